#include "app/gui/docks/review/review_dock.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTextBrowser>
#include <QVBoxLayout>
#include <utility>

#include "app/gui/base/looks/theme.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/name_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/docks/review/chart_panels.h"
#include "app/gui/docks/review/glazing/glazing_panel.h"
#include "app/gui/docks/review/glazing/glazing_session.h"
#include "app/gui/docks/review/verdict_table.h"
#include "app/gui/session/answers/answer_viewer.h"
#include "app/gui/session/project/project_session.h"
#include "app/gui/session/study/region_text.h"
#include "core/review/library/rule_text.h"
#include "core/review/places/verdict_text.h"
#include "core/study/prepare_review.h"

namespace noonmark {

namespace {

QString describeSums(const ReviewTotals& sums, UnitSystem units) {
    const auto share = [&](double m2h) {
        return sums.theoreticalM2h > 0 ? 100 * m2h / sums.theoreticalM2h : 0.0;
    };
    const auto text = [&](double m2h) {
        return localiseNumbers(QString::fromStdString(formatAreaHours(m2h, units)));
    };
    QString words = QObject::tr(
                        "Of a theoretical sum of %1, %2 % are in shadow in the baseline and %3 % in the "
                        "scenario; incremental shadow takes %4 (%5 %)")
                        .arg(text(sums.theoreticalM2h))
                        .arg(groupDigits(share(sums.baselineM2h), 2))
                        .arg(groupDigits(share(sums.scenarioM2h), 2))
                        .arg(text(sums.incrementalM2h))
                        .arg(groupDigits(share(sums.incrementalM2h), 2));
    if (sums.largestDay && sums.incrementalM2h > 0)
        words += QObject::tr(", most on %1").arg(QString::fromStdString(formatText(*sums.largestDay)));
    const double gainedM2h = sums.baselineM2h + sums.incrementalM2h - sums.scenarioM2h;
    if (share(gainedM2h) >= 0.005)
        words += QObject::tr("; sun comes back on %1 (%2 %)")
                     .arg(text(gainedM2h))
                     .arg(groupDigits(share(gainedM2h), 2));
    return words + u'.';
}

QString listOf(const QString& title, const std::vector<std::string>& texts) {
    if (texts.empty()) return {};
    QString html = QStringLiteral("<h4>%1</h4><ul>").arg(title);
    for (const std::string& text : texts)
        html += QStringLiteral("<li>%1</li>").arg(translated(ruleName(text).toStdString()).toHtmlEscaped());
    return html + QStringLiteral("</ul>");
}

}  // namespace

ReviewDock::ReviewDock(ReviewSession& review, GlazingSession& windows, ProjectSession& project,
                       QWidget* parent)
    : QWidget(parent),
      review_(review),
      windows_(windows),
      project_(project),
      copy_(new QPushButton(tr("Copy"))),
      export_(new QPushButton(tr("Export..."))),
      state_(new QLabel),
      details_(new QLabel),
      tables_(new QStackedWidget),
      table_(new VerdictTable),
      glazingPanel_(new GlazingPanel),
      glazingTable_(glazingPanel_->table()),
      tabs_(new QTabWidget),
      day_(new DayPanel),
      range_(new RangePanel),
      about_(new QTextBrowser) {
    auto* parts = new QSplitter(Qt::Horizontal);
    for (QWidget* part : {makeTable(), makeCharts()}) parts->addWidget(part);
    parts->setStretchFactor(0, 3);
    parts->setStretchFactor(1, 2);
    parts->setSizes({560, 430});
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(4, 2, 4, 2);
    column->addWidget(parts);
    connectSession();
    connectTable();
    showChart();
}

QWidget* ReviewDock::makeTable() {
    state_->setObjectName(QStringLiteral("reviewState"));
    state_->setWordWrap(true);
    copy_->setToolTip(tr("Copies the table, with all days, as text for a spreadsheet"));
    export_->setObjectName(QStringLiteral("exportReview"));
    export_->setToolTip(
        tr("Writes the sheets (PDF), the table (CSV), the data (JSON), and the shadows for CAD and GIS (DXF, "
           "GeoPackage)"));
    auto* row = new QHBoxLayout;
    row->addWidget(state_, 1);
    for (QWidget* button : {copy_, export_}) row->addWidget(button, 0, Qt::AlignTop);
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(2, 2, 2, 2);
    column->addLayout(row);
    tables_->addWidget(table_);
    tables_->addWidget(glazingPanel_);
    column->addWidget(tables_, 1);
    details_->setObjectName(QStringLiteral("verdictDetails"));
    details_->setWordWrap(true);
    details_->setTextFormat(Qt::PlainText);
    column->addWidget(details_);
    return content;
}

QWidget* ReviewDock::makeCharts() {
    about_->setObjectName(QStringLiteral("aboutRule"));
    about_->setOpenExternalLinks(false);
    tabs_->setDocumentMode(true);
    tabs_->addTab(day_, tr("Day"));
    tabs_->addTab(range_, tr("Range of days"));
    tabs_->addTab(about_, tr("Rule"));
    connect(range_, &RangePanel::dayChosen, this, [this](CivilDate day) {
        chosenDay_ = day;
        tabs_->setCurrentWidget(day_);
        showChart();
    });
    return tabs_;
}

void ReviewDock::connectSession() {
    connect(&review_, &ReviewSession::changed, this, &ReviewDock::showChoice);
    connect(&review_, &ReviewSession::answered, this, &ReviewDock::showAnswer);
    connect(&windows_, &GlazingSession::answered, this, &ReviewDock::showAnswer);
}

void ReviewDock::connectTable() {
    connect(copy_, &QPushButton::clicked, this, &ReviewDock::copyTable);
    connect(export_, &QPushButton::clicked, this, &ReviewDock::exportRequested);
    connect(&glazingTable_, &GlazingTable::described, this, [this](const QString& words) {
        if (!windows_.applies()) return;
        details_->setText(words);
        details_->setVisible(!words.isEmpty());
    });
    connect(table_, &VerdictTable::chosen, this, [this](std::size_t review, CivilDate day) {
        chosen_ = review;
        chosenDay_ = day;
        if (answer_) Q_EMIT placePointedAt(answer_->placeOf(review).name);
        showDetails();
        showChart();
    });
    connect(table_, &VerdictTable::zoomRequested, this, [this](std::size_t review) {
        if (answer_) Q_EMIT zoomRequested(answer_->placeOf(review).name);
    });
}

void ReviewDock::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    review_.setFollowing(true);
    showChoice();
    showAnswer();
}

void ReviewDock::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    review_.setFollowing(false);
}

void ReviewDock::showChoice() {
    if (!isVisible()) return;
    const bool ofGlazing = windows_.applies();
    tables_->setCurrentIndex(ofGlazing ? 1 : 0);
    ofGlazing ? glazingTable_.describeCurrent() : showDetails();
    showRule();
}

void ReviewDock::showAnswer() {
    if (!isVisible()) return;
    if (windows_.applies()) return showGlazing();
    const auto shown = review_.shown();
    showUnits();
    if (shown != answer_) {
        answer_ = shown;
        table_->show(answer_, units_);
        chosenDay_.reset();
        if (answer_)
            table_->chooseCurrent();
        else
            showChart();
        showDetails();
        showRule();
    }
    showState();
}

void ReviewDock::showGlazing() {
    if (std::exchange(glazingAnswer_, windows_.answer()) != windows_.answer()) {
        glazingTable_.show(glazingAnswer_);
        showRule();
    }
    const QString hint =
        tr("A rule about windows has no timeline: click a row to read when its window has sun.");
    day_->clear(hint);
    range_->clear(hint);
    showGlazingState();
}

void ReviewDock::showGlazingState() {
    copy_->setEnabled(glazingAnswer_ != nullptr);
    export_->setEnabled(glazingAnswer_ != nullptr);
    if (!glazingAnswer_) {
        const auto question = windows_.question();
        return state_->setText(question ? tr("Press Run review to evaluate the rule on the windows.")
                                        : describeError(question.error()));
    }
    const GlazingQuestion& asked = glazingAnswer_->question;
    QString text =
        tr("<b>%1</b>: %2 compared with %3. %4")
            .arg(ruleName(asked.rule.name).toHtmlEscaped(), scenarioName(asked.to).toHtmlEscaped(),
                 scenarioName(asked.from).toHtmlEscaped(), describeGlazingVerdicts(glazingAnswer_->study));
    if (const QString why = windows_.whyOutdated(); !why.isEmpty())
        text += QStringLiteral("<br><span style=\"color:%1\">%2</span>")
                    .arg(errorTextColour(themeInUse()).name(), why.toHtmlEscaped());
    state_->setText(text);
}

// The units of the project; a change of them keeps what is chosen.
void ReviewDock::showUnits() {
    const UnitSystem units = project_.project().sheets.units;
    if (std::exchange(units_, units) == units) return;
    table_->show(answer_, units_);
    day_->setUnits(units_);
    range_->setUnits(units_);
    showDetails();
}

// What the table shows and whether it is up to date; without an answer, what to do next.
void ReviewDock::showState() {
    copy_->setEnabled(answer_ != nullptr);
    export_->setEnabled(answer_ && !review_.isLive());
    if (!answer_) {
        const auto question = review_.question();
        if (review_.following().busy())
            return state_->setText(tr("Computing the verdicts of the building being designed..."));
        if (!question) return state_->setText(describeError(question.error()));
        if (const auto before = review_.measuredBefore())
            return state_->setText(tr("The project holds %1, see the list of Results. Run review shows its "
                                      "places and timelines again.")
                                       .arg(shownName(*before)));
        return state_->setText(
            question->from == question->to
                ? tr("Press Run review to see which places fail as the city stands, or design a tower.")
                : tr("Press Run review to evaluate the rule on the ticked places."));
    }
    const ReviewStudy& study = answer_->study;
    QString text =
        answer_->question.from == answer_->question.to
            ? tr("<b>%1</b>: %2 as it stands. %3")
                  .arg(ruleName(study.rule.name).toHtmlEscaped(),
                       scenarioName(answer_->question.to).toHtmlEscaped(), describeVerdicts(study))
            : tr("<b>%1</b>: %2 compared with %3. %4")
                  .arg(ruleName(study.rule.name).toHtmlEscaped(),
                       scenarioName(answer_->question.to).toHtmlEscaped(),
                       scenarioName(answer_->question.from).toHtmlEscaped(), describeVerdicts(study));
    if (review_.isLive()) text += tr("<br><i>Follows the building being designed.</i>");
    if (const QString why = review_.whyOutdated(); !why.isEmpty())
        text += QStringLiteral("<br><span style=\"color:%1\">%2</span>")
                    .arg(errorTextColour(themeInUse()).name(), why.toHtmlEscaped());
    state_->setText(text);
}

// The verdict in a sentence, and the sums of a range of days.
void ReviewDock::showDetails() {
    details_->setVisible(answer_ && chosenDay_);
    if (!answer_ || !chosenDay_) return;
    const PlaceReview& place = answer_->study.places[chosen_];
    QString text = tr("%1: %2.").arg(placeName(place.name),
                                     inWindowWords([&] { return describeReason(place, units_, writeDay); }));
    if (!hasFewDays(answer_->question.rule)) text += u' ' + describeSums(place.totals, units_);
    details_->setText(text);
}

void ReviewDock::showChart() {
    if (!answer_ || !chosenDay_) {
        const QString hint = answer_ ? tr("Click a row of the table to see its timeline.")
                                     : tr("The timeline of a place appears here after a review.");
        day_->clear(hint);
        return range_->clear(hint);
    }
    day_->show(answer_, chosen_, *chosenDay_);
    if (review_.isLive())
        range_->clear(tr("Build the tower, then run the review, to see its range of days."));
    else
        range_->show(answer_, chosen_);
}

// What the rule asks for, how sure it is, and what is not checked.
void ReviewDock::showRule() {
    const auto rule = review_.rule();
    if (!rule) return about_->setPlainText(describeError(rule.error()));
    QString html = QStringLiteral("<h3>%1</h3><p>%2</p><p><b>%3</b></p>")
                       .arg(ruleName(rule->name).toHtmlEscaped(), ruleName(rule->summary).toHtmlEscaped(),
                            describeStatus(*rule).toHtmlEscaped());
    const bool same = answer_ && answer_->study.rule.key == rule->key;
    const bool ofGlazing = glazingAnswer_ && glazingAnswer_->study.rule.key == rule->key;
    html += listOf(tr("Not checked"), same        ? answer_->study.notChecked
                                      : ofGlazing ? glazingAnswer_->study.notChecked
                                                  : rule->notChecked);
    html += listOf(tr("How Noonmark reads what the rule leaves open"), rule->readings);
    // What an answer states is English, with the trees of its city.
    const bool isEnglish = languageInUse() == Language::english;
    const std::string trees =
        same && isEnglish ? answer_->study.trees
        : ofGlazing && isEnglish
            ? glazingAnswer_->study.trees
            : inWindowWords([&] { return describeCountedTrees(rule->occluders.trees); }).toStdString();
    html += QStringLiteral("<p>%1</p>").arg(QString::fromStdString(trees).toHtmlEscaped());
    if (same)
        html += tr("<p>%1, steps of %2 min, cells of %3 m, %4, %5</p>")
                    .arg(QString::fromStdString(answer_->study.engine))
                    .arg(formatAmount(answer_->study.stepMinutes, 3))
                    .arg(formatAmount(answer_->study.settings.cellM, 3))
                    .arg(QString::fromStdString(answer_->study.clock).toHtmlEscaped())
                    .arg(answer_->study.year);
    std::vector<std::string> leftOut;
    for (const WarningGroup& group : groupWarnings(review_.library().warnings()))
        leftOut.push_back(describeWarningWithPlaces(group).toStdString());
    html += listOf(tr("Rule files that are left out"), leftOut);
    html += tr("<h4>Figures with status and source</h4>") +
            QStringLiteral("<pre style=\"white-space:pre-wrap\">%1</pre>").arg(inWindowWords([&] {
                                                                                   return describeRule(*rule);
                                                                               }).toHtmlEscaped());
    if (html != about_->property("shown").toString()) about_->setHtml(html);
    about_->setProperty("shown", html);
}

void ReviewDock::copyTable() {
    QGuiApplication::clipboard()->setText(windows_.applies() ? glazingTable_.text() : table_->text());
}

}  // namespace noonmark
