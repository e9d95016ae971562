#include "app/gui/docks/results/results_dock.h"

#include <QAction>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/base/looks/theme.h"
#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/name_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/session/answers/bar_charts.h"
#include "core/measures/shadow_figures.h"

namespace noonmark {

namespace {

constexpr double headlineSize = 1.3;  // of the font of the window
constexpr int maxNamePx = 165;        // longer names of figures take two lines, so that none widens the panel

QString defaultHint() {
    return ResultsDock::tr(
        "No study yet.\nChoose what, when and where in the panel Study, and press Run study (Ctrl+R). The "
        "answer then stands here.");
}

QLabel* headlineLabel() {
    QLabel* label = wrappedLabel("answerHeadline");
    QFont font = label->font();
    font.setPointSizeF(font.pointSizeF() * headlineSize);
    font.setBold(true);
    label->setFont(font);
    return label;
}

QToolButton* foldingHeading() {
    auto* heading = new QToolButton;
    heading->setObjectName(QStringLiteral("howMade"));
    heading->setText(ResultsDock::tr("How this was made"));
    heading->setToolTip(
        ResultsDock::tr("Period, engine, error, time, and the command that repeats this result"));
    heading->setCheckable(true);
    heading->setAutoRaise(true);
    heading->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    return heading;
}

QLabel* rowLabel(const QString& text, const QString& meaning) {
    auto* label = new QLabel(text);
    label->setToolTip(meaning);
    label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    return label;
}

void follow(QPushButton& button, QAction* action) {
    button.setCheckable(action->isCheckable());
    const auto look = [&button, action] {
        button.setEnabled(action->isEnabled());
        button.setChecked(action->isChecked());
    };
    QObject::connect(action, &QAction::changed, &button, look);
    QObject::connect(&button, &QPushButton::clicked, action, &QAction::trigger);
    button.setToolTip(action->toolTip());
    look();
}

}  // namespace

ResultsDock::ResultsDock(QWidget* parent)
    : QWidget(parent),
      scroll_(new QScrollArea),
      answers_(new QComboBox),
      trees_(new QComboBox),
      headline_(headlineLabel()),
      findings_(wrappedLabel("answerFindings")),
      note_(wrappedLabel("resultNote")),
      back_(pushButton(tr("Show the study again"), "wayBack",
                       tr("Replaces this result by the current study or comparison"))),
      allPlaces_(pushButton({}, "allPlaces", tr("Shows the figures of all places again"))),
      shadedBy_(pushButton(tr("Who shades it"), "resultContributors",
                           tr("Shows which buildings take sun from this place, and how much"))),
      charts_(new BarCharts),
      figures_(new QWidget),
      sections_(new QWidget),
      howMade_(foldingHeading()),
      method_(new QWidget),
      command_(pushButton(tr("Copy command"), "copyCommand",
                          tr("The command line that asks the same of the saved project or of the files"))),
      warnings_(pushButton({}, "answerWarnings",
                           tr("What was repaired, left out or assumed when the data was read"))),
      foot_(new QWidget),
      hint_(defaultHint()) {
    placeContent();
    placeFoot();
    answers_->setObjectName(QStringLiteral("answers"));
    answers_->setToolTip(tr("The answers of this session and those saved in the project, newest first"));
    answers_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    answers_->setPlaceholderText(tr("Show an earlier result"));
    setAnswers({}, -1);
    trees_->setObjectName(QStringLiteral("resultTrees"));
    trees_->setToolTip(tr("Which trees count in what is shown here and in the view"));
    setTrees({}, TreeColumns::without);
    connect(trees_, &QComboBox::activated, this,
            [this] { Q_EMIT treesChosen(TreeColumns(trees_->currentData().toInt())); });
    connect(answers_, &QComboBox::activated, this, &ResultsDock::answerChosen);
    connect(back_, &QPushButton::clicked, this, &ResultsDock::studyRequested);
    connect(allPlaces_, &QPushButton::clicked, this, &ResultsDock::allPlacesRequested);
    connect(shadedBy_, &QPushButton::clicked, this, &ResultsDock::contributorsRequested);
    connect(command_, &QPushButton::clicked, this, &ResultsDock::commandRequested);
    connect(warnings_, &QPushButton::clicked, this, &ResultsDock::warningsRequested);
    connect(howMade_, &QToolButton::toggled, this, &ResultsDock::showMethod);
    setWarningCount(0);
    show({}, {});
}

void ResultsDock::placeContent() {
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    for (QWidget* each :
         std::initializer_list<QWidget*>{allPlaces_, headline_, findings_, note_, back_, charts_, figures_,
                                         shadedBy_, sections_, howMade_, method_, command_, warnings_})
        column->addWidget(each);
    column->addStretch(1);
    auto* sections = new QVBoxLayout(sections_);
    sections->setContentsMargins(0, 0, 0, 0);
    scroll_->setWidget(content);
    scroll_->setWidgetResizable(true);
    scroll_->setFrameShape(QFrame::NoFrame);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->setSpacing(0);
    whole->addWidget(answers_);
    whole->addWidget(trees_);
    whole->addWidget(scroll_, 1);
    whole->addWidget(foot_);
}

void ResultsDock::placeFoot() {
    auto* row = new QHBoxLayout(foot_);
    for (QPushButton* button :
         {pushButton(tr("Save"), "answerSave", {}), pushButton(tr("Compare"), "answerCompare", {}),
          pushButton(tr("Export..."), "answerExport", {})})
        row->addWidget(button);
}

void ResultsDock::setActions(QAction* save, QAction* compare, QAction* exporting) {
    int at = 0;
    for (QAction* action : {save, compare, exporting})
        follow(*qobject_cast<QPushButton*>(foot_->layout()->itemAt(at++)->widget()), action);
}

void ResultsDock::setAnswers(const QStringList& names, int shown) {
    const QSignalBlocker quiet(answers_);
    answers_->clear();
    answers_->addItems(names);
    answers_->setCurrentIndex(shown);
    answers_->setVisible(names.size() > 1 || (!names.isEmpty() && shown < 0));
}

void ResultsDock::setTrees(const std::vector<TreeColumns>& columns, TreeColumns shown) {
    const QSignalBlocker quiet(trees_);
    trees_->clear();
    const auto add = [this](TreeColumns column) {
        trees_->addItem(translatedSentence(describeTrees(column)), int(column));
    };
    add(TreeColumns::without);
    for (const TreeColumns column : columns) add(column);
    trees_->setCurrentIndex(std::max(0, trees_->findData(int(shown))));
    trees_->setVisible(!columns.empty());
}

void ResultsDock::addSection(QWidget* section) {
    sections_->layout()->addWidget(section);
    sections_->setVisible(filled_);
}

QString ResultsDock::headline() const { return headline_->text().replace(QChar::Nbsp, u' '); }

void ResultsDock::show(const AnswerPage& page, const std::vector<ResultRow>& rows) {
    filled_ = !rows.empty();
    rows_ = rows;
    QStringList findings;
    for (const Sentence& finding : page.findings) findings << sentenceText(finding);
    headline_->setText(keepUnits(sentenceText(page.headline)));
    findings_->setText(keepUnits(findings.join(QLatin1Char(' '))));
    charts_->show(page.charts);
    fillRows(*figures_, false);
    fillRows(*method_, true);
    sections_->setVisible(filled_ && sections_->layout()->count() > 0);
    foot_->setVisible(filled_);
    showMethod();
    setNote({});
    showBackButton(false, false);
    for (QPushButton* button : {allPlaces_, shadedBy_}) button->hide();
}

// No QFormLayout: in 6.4 it gives wrapped text too little height below another layout.
void ResultsDock::fillRows(QWidget& widget, bool ofMethod) {
    qDeleteAll(widget.findChildren<QWidget*>(Qt::FindDirectChildrenOnly));
    delete widget.layout();
    auto* grid = new QGridLayout(&widget);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setColumnStretch(1, 1);
    for (const ResultRow& row : rows_) {
        if (row.isMethod != ofMethod) continue;
        QLabel* value = rowLabel(keepUnits(row.value), row.meaning);
        value->setWordWrap(true);
        value->setTextInteractionFlags(Qt::TextSelectableByMouse);
        const int at = grid->rowCount();
        QLabel* name = rowLabel(row.name, row.meaning);
        name->setWordWrap(true);
        name->setMinimumWidth(std::min(name->fontMetrics().horizontalAdvance(row.name) + 2, maxNamePx));
        if (!row.subject.isEmpty()) {
            name->setText(makeLink(row.subject, row.name));
            connect(name, &QLabel::linkActivated, this, &ResultsDock::subjectRequested);
        }
        grid->addWidget(name, at, 0);
        grid->addWidget(value, at, 1);
    }
}

void ResultsDock::showMethod() {
    const bool open = howMade_->isChecked();
    howMade_->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    howMade_->setVisible(filled_);
    method_->setVisible(open && filled_);
    command_->setVisible(open && filled_);
}

void ResultsDock::setNote(const QString& note, bool warns) {
    const bool amber = filled_ && warns;
    const NoteColours colours = warningColours(themeInUse());
    note_->setStyleSheet(amber ? QStringLiteral("background: %1; color: %2; padding: 4px;")
                                     .arg(colours.background.name(), colours.text.name())
                               : QString());
    if (filled_) hint_ = defaultHint();
    note_->setText(filled_ ? note : hint_);
    setFaded(amber && !note.isEmpty());
    fitLabels();
}

// Sets the height of the texts that come and go, since the layout gives a wrapped label no height when it
// returns.
void ResultsDock::fitLabels() {
    const QMargins margins = scroll_->widget()->layout()->contentsMargins();
    const int width = std::max(1, scroll_->viewport()->width() - margins.left() - margins.right());
    for (QLabel* label : {headline_, findings_, note_}) {
        label->setVisible(!label->text().isEmpty());
        label->setMinimumHeight(label->text().isEmpty() ? 0 : label->heightForWidth(width));
    }
}

void ResultsDock::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fitLabels();
}

void ResultsDock::setHint(const QString& hint) {
    hint_ = hint.isEmpty() ? defaultHint() : hint;
    if (!filled_) setNote({});
}

void ResultsDock::setWarningCount(std::size_t warnings) {
    warnings_->setText(
        tr("%1 warning(s) about the data", "", pluralNumber(warnings)).arg(formatCount(warnings)));
    warnings_->setVisible(warnings > 0);
}

// Greys out what does not belong to what is displayed.
void ResultsDock::setFaded(bool faded) {
    faded_ = faded;
    const QString style = faded ? QStringLiteral("color: #8b909a;") : QString();
    for (QWidget* each : std::initializer_list<QWidget*>{headline_, findings_, figures_, method_})
        each->setStyleSheet(style);
}

void ResultsDock::showBackButton(bool offered, bool toStudy) {
    back_->setText(toStudy ? tr("Show the study again") : tr("Hide this result"));
    back_->setVisible(offered);
}

void ResultsDock::showTop() { scroll_->verticalScrollBar()->setValue(0); }

void ResultsDock::offerAllPlaces(std::size_t places) {
    allPlaces_->setText(tr("Back to all %1 place(s)", "", pluralNumber(places)).arg(formatCount(places)));
    for (QPushButton* button : {allPlaces_, shadedBy_}) button->show();
}

namespace {

// Limits the rows per kind; study.json lists all.
constexpr std::size_t maxPlaces = 2000;

QTreeWidgetItem* itemOf(const WarningGroup& group) {
    auto* item = new QTreeWidgetItem({describeWarning(group)});
    item->setToolTip(0, item->text(0));
    const std::size_t shown = std::min(group.where.size(), maxPlaces);
    for (std::size_t i = 0; i < shown; ++i)
        item->addChild(new QTreeWidgetItem({QString::fromStdString(group.where[i])}));
    if (shown < group.where.size())
        item->addChild(new QTreeWidgetItem(
            {QObject::tr("and %1 more, listed in study.json of an export").arg(group.where.size() - shown)}));
    return item;
}

}  // namespace

WarningsDock::WarningsDock(QWidget* parent) : QTreeWidget(parent) {
    setHeaderHidden(true);
    setFrameShape(QFrame::NoFrame);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setToolTip(tr("Double-click a feature or press Enter to go to its building"));
    connect(this, &QTreeWidget::itemActivated, this, [this](const QTreeWidgetItem* item) {
        if (item->parent()) Q_EMIT placeChosen(item->text(0));
    });
    show({});
}

void WarningsDock::show(const Warnings& warnings) {
    clear();
    for (const WarningGroup& group : groupWarnings(warnings)) addTopLevelItem(itemOf(group));
    if (warnings.empty())
        addTopLevelItem(new QTreeWidgetItem({tr("No warnings: nothing was left out, repaired or assumed")}));
}

}  // namespace noonmark
