#include "app/gui/docks/point/point_dock.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QEvent>
#include <QFileInfo>
#include <QFormLayout>
#include <QHeaderView>
#include <QImage>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSvgRenderer>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <numeric>

#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/name_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/docks/point/point_inspector.h"
#include "app/report/skyline/skyline_svg.h"
#include "core/io/files/write_text.h"
#include "core/measures/shadow_figures.h"
#include "core/study/text/point_text.h"

namespace noonmark {

/// The drawing of a sky in a scroll area: so wide that the skyline, its upper part, is seen whole.
class SkyPicture final : public QWidget {
public:
    explicit SkyPicture(QWidget* parent = nullptr);

    void setDrawing(const QByteArray& svg);  ///< empty: nothing
    void fitInto(QSize room);                ///< the visible size
    /// The drawing as a picture of this width.
    [[nodiscard]] QImage image(int widthPx);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] int heightFor(int widthPx) const;

    QSvgRenderer renderer_;
    QSize room_{0, 0};
};

namespace {

constexpr int minWidthPx = 420;

}  // namespace

SkyPicture::SkyPicture(QWidget* parent) : QWidget(parent) {}

void SkyPicture::setDrawing(const QByteArray& svg) {
    renderer_.load(svg);
    fitInto(room_);
    update();
}

void SkyPicture::fitInto(QSize room) {
    room_ = room;
    const int width = std::min(
        room.width(), std::max(minWidthPx, int(room.height() * skylineSvgWidthPx / skylineSvgUpperPx)));
    setFixedSize(width, heightFor(width));
}

int SkyPicture::heightFor(int widthPx) const {
    const QSize size = renderer_.defaultSize();
    return renderer_.isValid() && size.width() > 0 ? widthPx * size.height() / size.width() : 0;
}

QImage SkyPicture::image(int widthPx) {
    QImage image(widthPx, std::max(1, heightFor(widthPx)), QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    renderer_.render(&painter);
    return image;
}

void SkyPicture::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    renderer_.render(&painter, QRectF(rect()));
}

namespace {

enum Column { scenarioColumn, dayColumn, yearColumn, changeColumn, skyColumn, componentColumn, columnCount };

QComboBox* scenarioList(const char* name, const QString& tip) {
    auto* list = new QComboBox;
    list->setObjectName(QString::fromLatin1(name));
    list->setToolTip(tip);
    list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    list->setMinimumContentsLength(10);
    return list;
}

void fillScenarios(QComboBox& list, const QString& standard, const QStringList& names,
                   const std::string& now) {
    const QSignalBlocker quiet(list);
    list.clear();
    list.addItem(standard);
    for (const QString& name : names) list.addItem(scenarioName(name.toStdString()), name);
    list.setCurrentIndex(now.empty() ? 0 : std::max(0, list.findData(QString::fromStdString(now))));
}

std::string chosenIn(const QComboBox& list) {
    return list.currentIndex() <= 0 ? std::string() : list.currentData().toString().toStdString();
}

// The first line of a scenario has its name, further ones which trees they count.
QStringList textsOf(const std::string& scenario, const PointCaseLine& line, bool wall) {
    const PointCaseShade& shade = line.shade;
    const double change = line.changeMin / 60;
    return {shade.column == TreeColumns::without
                ? scenarioName(scenario)
                : QStringLiteral("    ") + translated(describeTrees(shade.column)),
            groupDigits(shade.dayMin, 0),
            groupDigits(shade.yearMin / 60, 0),
            withPlus(change, groupDigits(change, 1)),
            groupDigits(shade.skyView, 3),
            wall ? groupDigits(shade.skyComponentPct, 1) : QString()};
}

/// A row of the table: its texts, or a name and why the point is not measured there.
struct CaseRow {
    QStringList texts;
    bool isMeasured = true;
};

std::vector<CaseRow> rowsOf(const std::vector<PointCaseFigures>& cases, bool wall) {
    std::vector<CaseRow> rows;
    for (const PointCaseFigures& one : cases) {
        if (!one.why.empty()) {
            rows.push_back({{scenarioName(one.name), QString::fromStdString(one.why)}, false});
            continue;
        }
        for (const PointCaseLine& line : listCaseLines(one, cases.front()))
            rows.push_back({textsOf(one.name, line, wall)});
    }
    return rows;
}

}  // namespace

PointScenarios::PointScenarios(PointInspector& inspector, QWidget* parent)
    : QWidget(parent), inspector_(inspector) {
    makeFields();
    connect(from_, &QComboBox::activated, this, &PointScenarios::choose);
    connect(to_, &QComboBox::activated, this, &PointScenarios::choose);
    connect(&inspector_, &PointInspector::scenariosChanged, this, &PointScenarios::fillLists);
    connect(&inspector_, &PointInspector::changed, this, &PointScenarios::showTable);
    fillLists();
    showTable();
}

void PointScenarios::makeFields() {
    from_ = scenarioList("pointFrom", tr("The scenario before: what the other one is compared with"));
    to_ = scenarioList("pointTo", tr("The scenario whose sun at the point is compared"));
    table_ = new QTableWidget(0, columnCount);
    table_->setObjectName(QStringLiteral("pointScenarios"));
    table_->setToolTip(
        tr("The point's sun and sky in every scenario of the project, without trees where a row says nothing "
           "else. Copy (Ctrl+C) takes the table"));
    table_->setHorizontalHeaderLabels(
        {tr("Scenario"), tr("Day, min"), tr("Year, h"), tr("Change, h"), tr("Sky view"), tr("VSC, %")});
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    auto* lists = new QFormLayout;
    lists->setContentsMargins(0, 0, 0, 0);
    lists->addRow(tr("Before"), from_);
    lists->addRow(tr("After"), to_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(lists);
    column->addWidget(table_);
}

void PointScenarios::fillLists() {
    const QStringList names = inspector_.scenarios();
    fillScenarios(*from_, tr("the baseline"), names, inspector_.comparison().from);
    fillScenarios(*to_, tr("the displayed scenario"), names, inspector_.comparison().to);
    setVisible(names.size() > 1);
}

void PointScenarios::choose() { inspector_.compare({chosenIn(*from_), chosenIn(*to_)}); }

void PointScenarios::showTable() {
    const auto answer = inspector_.answer();
    const std::vector<CaseRow> cases =
        answer ? rowsOf(answer->cases, answer->study.question.facingDeg.has_value()) : std::vector<CaseRow>();
    table_->setVisible(!cases.empty());
    table_->clearSpans();
    table_->setRowCount(int(cases.size()));
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const auto& [texts, isMeasured] = cases[i];
        for (int column = 0; column < columnCount; ++column) {
            auto* item = new QTableWidgetItem(texts.value(column));
            if (isMeasured && column > scenarioColumn)
                item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            table_->setItem(int(i), column, item);
        }
        if (!isMeasured) table_->setSpan(int(i), dayColumn, 1, columnCount - 1);
    }
    table_->resizeColumnsToContents();
    const int rows = table_->verticalHeader()->defaultSectionSize() * std::min(8, table_->rowCount());
    table_->setFixedHeight(rows + table_->horizontalHeader()->sizeHint().height() + 20);
}

namespace {

constexpr int textWidth = 300;
constexpr int savedWidthPx = 2400;

double hoursOf(const MonthHours& minutes) {
    const auto months = sumMonths(minutes);
    return std::accumulate(months.begin(), months.end(), 0.0) / 60;
}

QString treesOf(const PointCrowns& crowns) {
    return PointDock::tr(
               "%1 min on the day and %2 h in the year with their seasons; %3 min and %4 h as evergreens")
        .arg(groupDigits(crowns.seasonal.dayMin, 0), groupDigits(hoursOf(crowns.seasonal.minutes), 0),
             groupDigits(crowns.evergreen.dayMin, 0), groupDigits(hoursOf(crowns.evergreen.minutes), 0));
}

QString skyWithTrees(const PointCrowns& crowns, bool wall) {
    QString text =
        PointDock::tr("\nSky view factor with trees: %1 with their seasons, %2 as evergreens")
            .arg(groupDigits(crowns.seasonal.sky.skyView, 3), groupDigits(crowns.evergreen.sky.skyView, 3));
    if (wall)
        text += PointDock::tr("\nVertical sky component with trees: %1 % and %2 %")
                    .arg(groupDigits(crowns.seasonal.sky.skyComponentPct, 1),
                         groupDigits(crowns.evergreen.sky.skyComponentPct, 1));
    return text;
}

QString figuresOf(const PointView& view, const PointStudy& study, const Zone& zone) {
    const double lit = study.possibleMin - view.year.grossMin * double(study.sun.dayCount());
    QString text = PointDock::tr("In the sun on %1: %2\nIn the year: %3 h of %4 h\nSky view factor: %5")
                       .arg(QLocale().toString(dateOf(study.question.day), dayOfYear()),
                            QString::fromStdString(sunlitText(view.sunlit, zone)))
                       .arg(groupDigits(lit / 60, 0))
                       .arg(groupDigits(study.possibleMin / 60, 0))
                       .arg(groupDigits(view.factors.skyView, 3));
    if (view.crowns) {
        for (const TreeColumns column : PointCrowns::columns)
            text += PointDock::tr("\nIn the sun on %1, %2: %3", "a day, trees as evergreens, times")
                        .arg(QLocale().toString(dateOf(study.question.day), dayOfYear()),
                             translated(describeTrees(column)),
                             QString::fromStdString(sunlitText(view.crowns->of(column).sunlit, zone)));
        text += PointDock::tr("\nWith trees: %1").arg(treesOf(*view.crowns));
    }
    if (study.question.facingDeg)
        text +=
            PointDock::tr("\nVertical sky component: %1 %").arg(groupDigits(view.factors.skyComponentPct, 1));
    if (view.crowns) text += skyWithTrees(*view.crowns, study.question.facingDeg.has_value());
    return text;
}

// Rich text: each name leads to its tree. Empty: none takes any.
QString takenByTrees(const PointCrowns& crowns) {
    constexpr std::size_t maximum = 5;
    const std::vector<TreeMinutes> trees = listTakenByTree(crowns);
    if (trees.empty()) return {};
    QStringList lines{PointDock::tr("Trees that take most sun, with their seasons:")};
    for (std::size_t i = 0; i < std::min(maximum, trees.size()); ++i) {
        const Tree& tree = crowns.trees->trees[trees[i].tree];
        const QString id = QString::fromStdString(tree.sourceId);
        const QString name = tree.species.empty()
                                 ? id
                                 : QStringLiteral("%1 (%2)").arg(QString::fromStdString(tree.species), id);
        lines << PointDock::tr("%1: %2 min on the day, %3 h in the year", "a tree, and the sun it takes")
                     .arg(makeLink(id, name), groupDigits(trees[i].daySeasonal, 0),
                          groupDigits(trees[i].yearSeasonal / 60, 1));
    }
    if (const std::size_t more = trees.size() - std::min(maximum, trees.size()); more > 0)
        lines << PointDock::tr("and %1 more tree(s)", "", pluralNumber(more)).arg(formatCount(more));
    return lines.join(QStringLiteral("<br>"));
}

QLabel* makeText() {
    auto* label = new QLabel;
    label->setWordWrap(true);
    label->setAlignment(Qt::AlignTop);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

}  // namespace

PointDock::PointDock(PointInspector& inspector, QWidget* parent)
    : QWidget(parent),
      inspector_(inspector),
      sentence_(makeText()),
      figures_(makeText()),
      taken_(makeText()),
      save_(new QPushButton(tr("Save..."))),
      picture_(new SkyPicture),
      scroll_(new QScrollArea) {
    scroll_->setWidget(picture_);
    scroll_->setFrameShape(QFrame::NoFrame);
    scroll_->viewport()->installEventFilter(this);
    auto* row = new QHBoxLayout(this);
    row->addWidget(makeSide());
    row->addWidget(scroll_, 1);
    figures_->setObjectName(QStringLiteral("pointFigures"));
    taken_->setObjectName(QStringLiteral("takenByTrees"));
    taken_->setTextInteractionFlags(Qt::TextBrowserInteraction);
    taken_->hide();
    connect(taken_, &QLabel::linkActivated, this, &PointDock::treeRequested);
    connect(save_, &QPushButton::clicked, this, &PointDock::saveRequested);
    connect(&inspector_, &PointInspector::changed, this, &PointDock::showAnswer);
    connect(&inspector_, &PointInspector::failed, this, &PointDock::showError);
    showAnswer();
}

// The texts and the button, which scroll where the dock is low.
QWidget* PointDock::makeSide() {
    save_->setToolTip(tr("The drawing as SVG or PNG, or the minutes by month and hour as CSV"));
    auto* side = new QWidget;
    auto* texts = new QVBoxLayout(side);
    texts->addWidget(sentence_);
    texts->addWidget(figures_);
    texts->addWidget(taken_);
    texts->addWidget(new PointScenarios(inspector_));
    texts->addWidget(save_, 0, Qt::AlignLeft);
    texts->addStretch();
    auto* scroll = new QScrollArea;
    scroll->setWidget(side);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFixedWidth(textWidth);
    return scroll;
}

void PointDock::showEvent(QShowEvent* /*event*/) { inspector_.setVisible(true); }

void PointDock::hideEvent(QHideEvent* /*event*/) { inspector_.setVisible(false); }

bool PointDock::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) picture_->fitInto(scroll_->viewport()->size());
    return QWidget::eventFilter(watched, event);
}

void PointDock::showAnswer() {
    const auto answer = inspector_.answer();
    save_->setVisible(answer != nullptr);
    picture_->setDrawing(answer ? answer->drawing : QByteArray());
    figures_->clear();
    taken_->hide();
    sentence_->setText(tr("Right-click the ground, a roof or a wall and choose Sun and sky here."));
    if (!answer) return;
    sentence_->setText(answer->sentence);
    const auto zone = Zone::named(answer->study.question.zone);
    if (!zone) return;
    QString figures = figuresOf(answer->study.baseline, answer->study, *zone);
    if (answer->study.scenario)
        figures = tr("Before: %1\n%2\n\nAfter: %3\n%4")
                      .arg(QString::fromStdString(answer->from), figures, QString::fromStdString(answer->to),
                           figuresOf(*answer->study.scenario, answer->study, *zone));
    figures_->setText(figures);
    const PointView& shown = answer->study.scenario ? *answer->study.scenario : answer->study.baseline;
    taken_->setText(shown.crowns ? takenByTrees(*shown.crowns) : QString());
    taken_->setVisible(!taken_->text().isEmpty());
}

void PointDock::showError(const Error& error) { sentence_->setText(describeError(error)); }

Result<void> PointDock::save(const QString& file, const OutputRules& rules) {
    const auto answer = inspector_.answer();
    if (!answer || file.isEmpty()) return {};
    const QString ending = QFileInfo(file).suffix().toLower();
    const OutputKind kind = ending == QStringLiteral("png")   ? OutputKind::picture
                            : ending == QStringLiteral("csv") ? OutputKind::table
                                                              : OutputKind::svg;
    if (const auto may = checkOutput(file.toStdString(), kind, rules); !may) return may;
    if (kind == OutputKind::svg) return writeText(file.toStdString(), answer->drawing.toStdString());
    if (kind == OutputKind::table) return writeText(file.toStdString(), pointCsv(answer->study));
    if (picture_->image(savedWidthPx).save(file)) return {};
    return failure("The picture could not be written", file.toStdString(), "Choose another folder");
}

}  // namespace noonmark
