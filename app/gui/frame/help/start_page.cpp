#include "app/gui/frame/help/start_page.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileInfo>
#include <QKeyEvent>
#include <QLabel>
#include <QMainWindow>
#include <QMimeData>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QShortcut>
#include <QStatusBar>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/gui/base/files/file_dialogs.h"
#include "app/gui/base/looks/theme.h"
#include "app/gui/base/widgets/buttons.h"
#include "app/gui/frame/tour/tour.h"
#include "app/gui/view/panel/view_panel.h"

namespace noonmark {

namespace {

const QString showStartKey = QStringLiteral("showStart");

}  // namespace

bool readShowStart(const QSettings& settings) { return settings.value(showStartKey, true).toBool(); }

void saveShowStart(bool shows, QSettings& settings) { settings.setValue(showStartKey, shows); }

namespace {

constexpr int sidePx = 400;  // of each side, unless the docks are wider
constexpr int cardGapPx = 8;
constexpr int iconPx = 32;
constexpr QSize thumbnailPx{96, 64};
constexpr qsizetype maxRecent = 4;

constexpr StartCard startCards[] = {
    {StartQuestion::places, QT_TRANSLATE_NOOP("StartQuestion", "How sunny are our parks and streets?"),
     QT_TRANSLATE_NOOP("StartQuestion", "Hours of sun by place and month, and what lies below a threshold"),
     "sun"},
    {StartQuestion::tower, QT_TRANSLATE_NOOP("StartQuestion", "What would a tower change?"),
     QT_TRANSLATE_NOOP("StartQuestion",
                       "New shadow, the worst spot and the places it reaches, live while you drag"),
     "tower"},
    {StartQuestion::review, QT_TRANSLATE_NOOP("StartQuestion", "Does this proposal pass the rules?"),
     QT_TRANSLATE_NOOP("StartQuestion",
                       "Verdicts by the rules of review boards, the site's first, and a book to file"),
     "review"},
    {StartQuestion::facades, QT_TRANSLATE_NOOP("StartQuestion", "Which facades and windows get sun?"),
     QT_TRANSLATE_NOOP("StartQuestion", "Hours of sun and daylight at points of the facades"), "front-view"},
    {StartQuestion::score, QT_TRANSLATE_NOOP("StartQuestion", "Is the shade where we want it?"),
     QT_TRANSLATE_NOOP("StartQuestion",
                       "Wanted shade in summer against unwanted shadow in winter, by hour and month"),
     "analyse"},
};

QLabel* wrapped(const QString& text) {
    auto* label = new QLabel(text);
    label->setWordWrap(true);
    return label;
}

QLabel* makeHeading(const QString& text, double scale) {
    QLabel* label = wrapped(text);
    QFont font = label->font();
    font.setBold(true);
    font.setPointSizeF(font.pointSizeF() * scale);
    label->setFont(font);
    return label;
}

// Its height follows from its width: labels that wrap have no minimum of their own, at no width.
class ColumnContent final : public QWidget {
public:
    [[nodiscard]] QSize minimumSizeHint() const override { return {QWidget::minimumSizeHint().width(), 0}; }
};

// A side that scrolls where a screen is low, so that nothing is cut.
QVBoxLayout* makeColumn(QFrame& side) {
    side.setAutoFillBackground(true);
    side.setFrameShape(QFrame::NoFrame);
    auto* content = new ColumnContent;
    auto* scroll = new QScrollArea;
    scroll->setWidget(content);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    auto* around = new QVBoxLayout(&side);
    around->setContentsMargins(0, 0, 0, 0);
    around->addWidget(scroll);
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(2 * cardGapPx, 2 * cardGapPx, 2 * cardGapPx, cardGapPx);
    column->setSpacing(cardGapPx);
    return column;
}

// The picture of a recent entry, or a blank map with the icon in its middle.
QPixmap thumbnail(const QImage& picture, const char* icon, const QWidget& of) {
    QPixmap shown(thumbnailPx * of.devicePixelRatioF());
    shown.setDevicePixelRatio(of.devicePixelRatioF());
    shown.fill(of.palette().color(QPalette::AlternateBase));
    QPainter painter(&shown);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const QRect all({}, thumbnailPx);
    if (!picture.isNull())
        painter.drawImage(all, picture);
    else
        makeIcon(QString::fromLatin1(icon)).paint(&painter, all.adjusted(32, 16, -32, -16));
    return shown;
}

QPushButton* makeLink(const QString& text, const char* name, const QString& tip) {
    QPushButton* link = pushButton(text, name, tip);
    link->setFlat(true);
    link->setCursor(Qt::PointingHandCursor);
    link->setStyleSheet(
        QStringLiteral("QPushButton { color: palette(link); text-align: left; padding: 2px; }"
                       "QPushButton:focus { border: 1px solid palette(highlight); }"));
    return link;
}

}  // namespace

std::span<const StartCard> listStartCards() { return startCards; }

StartPage::StartPage(const RecentFiles& recent, bool cityChosen, QMainWindow& window, ViewPanel& view)
    : QFrame(&window),
      window_(window),
      view_(view),
      cityChosen_(cityChosen),
      questions_(new QFrame(&window)),
      heading_(makeHeading(tr("Open a city"), 1.4)) {
    setObjectName(QStringLiteral("startPage"));
    questions_->setObjectName(QStringLiteral("startQuestions"));
    setAttribute(Qt::WA_DeleteOnClose);
    setAcceptDrops(true);
    makeOpening(recent);
    makeQuestions();
    for (QWidget* side : {static_cast<QWidget*>(this), static_cast<QWidget*>(questions_)}) {
        side->setAttribute(Qt::WA_NativeWindow);  // the view's own window would lie above anything else
        auto* leave = new QShortcut(Qt::Key_Escape, side);
        leave->setContext(Qt::WidgetWithChildrenShortcut);
        connect(leave, &QShortcut::activated, this, &QWidget::close);
    }
    window_.installEventFilter(this);
    view.installEventFilter(this);
    view_.setBare(true);
    hidePanelsBelow();
    place();
    questions_->show();
    questions_->raise();
}

StartPage::~StartPage() {
    showPanelsBelow();
    view_.setBare(false);
    view_.setCovered(0, 0);
    delete questions_;
}

// The sides lie over the panels beside the view; those below would show through between them.
void StartPage::hidePanelsBelow() {
    for (QDockWidget* dock : window_.findChildren<QDockWidget*>()) {
        const bool isBelow = window_.dockWidgetArea(dock) == Qt::BottomDockWidgetArea && !dock->isFloating();
        if (!isBelow || dock->isHidden()) continue;
        dock->hide();
        below_ << dock;
    }
}

void StartPage::showPanelsBelow() {
    for (const auto& dock : std::exchange(below_, {}))
        if (dock) dock->show();
}

// Before the window saves which panels are shown.
void StartPage::closeEvent(QCloseEvent* event) {
    showPanelsBelow();
    QFrame::closeEvent(event);
}

void StartPage::makeOpening(const RecentFiles& recent) {
    QVBoxLayout* column = makeColumn(*this);
    auto* top = new QHBoxLayout;
    top->addWidget(heading_, 1);
    auto* close = makeLink(tr("Close"), "startClose", tr("Closes the start page (Esc)"));
    connect(close, &QPushButton::clicked, this, &QWidget::close);
    top->addWidget(close, 0, Qt::AlignTop);
    column->addLayout(top);
    column->addWidget(
        wrapped(tr("Drop files or a folder here: OpenStreetMap, GeoPackage, CityJSON, CityGML, IFC, meshes, "
                   "terrain.")));
    addOpenButtons(*column);
    addRecent(*column, recent);
    addSamples(*column, recent);
    addLinks(*column);
    column->addStretch(1);
}

void StartPage::addOpenButtons(QVBoxLayout& column) {
    auto* row = new QHBoxLayout;
    QPushButton* file = pushButton(tr("Open file..."), "startOpen", tr("A project or city files (Ctrl+O)"));
    QPushButton* folder = pushButton(tr("Open folder..."), "startFolder",
                                     tr("A folder of city files, such as tiles or a file geodatabase"));
    file->setDefault(true);
    for (QPushButton* button : {file, folder}) {
        button->setMinimumHeight(4 * cardGapPx);
        row->addWidget(button, 1);
    }
    connect(file, &QPushButton::clicked, this, &StartPage::openRequested);
    connect(folder, &QPushButton::clicked, this, &StartPage::folderRequested);
    column.addLayout(row);
}

void StartPage::addRecent(QVBoxLayout& column, const RecentFiles& recent) {
    QStringList entries;
    for (const QString& entry : recent.entries())
        if (!RecentFiles::isSampleEntry(entry)) entries << entry;
    if (entries.isEmpty()) return;
    column.addWidget(makeHeading(tr("Recent"), 1));
    for (const QString& entry : entries.mid(0, maxRecent)) {
        const QStringList files = RecentFiles::filesOf(entry);
        const bool there = RecentFiles::exists(entry);
        const QString folder = fontMetrics().elidedText(QFileInfo(files.first()).absolutePath(),
                                                        Qt::ElideMiddle, sidePx - thumbnailPx.width() - 90);
        auto* card =
            new CardButton(thumbnail(recent.pictureOf(entry), "map", *this), RecentFiles::nameOf(entry),
                           there ? folder : tr("No longer there: %1").arg(folder), "startRecent");
        card->setToolTip(entry);
        card->setEnabled(there);
        connect(card, &CardButton::clicked, this,
                [this, files, reading = recent.readingOf(entry)] { Q_EMIT chosen(files, reading); });
        column.addWidget(card);
    }
}

void StartPage::addSamples(QVBoxLayout& column, const RecentFiles& recent) {
    column.addWidget(makeHeading(tr("Samples"), 1));
    auto* row = new QHBoxLayout;
    const auto add = [&](const QString& title, const QString& tip, const char* name, const QString& sample) {
        auto* card = new CardButton(
            thumbnail(recent.pictureOf(sample), "map", *this).scaledToHeight(40, Qt::SmoothTransformation),
            title, {}, name);
        card->setToolTip(tip);
        connect(card, &CardButton::clicked, this, [this, sample] { Q_EMIT chosen({sample}, {}); });
        row->addWidget(card, 1);
    };
    add(tr("Central Park South"), tr("The park, its streets and the towers of the case study"), "startPark",
        QStringLiteral("sample:central-park-south"));
    add(tr("Grid"), tr("A synthetic city of blocks and lots"), "startGrid", QStringLiteral("sample:grid"));
    column.addLayout(row);
}

void StartPage::addLinks(QVBoxLayout& column) {
    column.addWidget(makeHeading(tr("Guided tours and help"), 1));
    auto* links = new QVBoxLayout;
    links->setSpacing(0);
    const auto tours = listTours();
    for (std::size_t i = 0; i < tours.size(); ++i) {
        QPushButton* link = makeLink(titleOf(tours[i]), "startTour", aboutOf(tours[i]));
        connect(link, &QPushButton::clicked, this, [this, i] { Q_EMIT tourRequested(i); });
        links->addWidget(link);
    }
    QPushButton* guide =
        makeLink(tr("User guide (F1)"), "startGuide", tr("How to study, compare and review"));
    connect(guide, &QPushButton::clicked, this, &StartPage::guideRequested);
    links->addWidget(guide);
    column.addLayout(links);
}

void StartPage::makeQuestions() {
    QVBoxLayout* column = makeColumn(*questions_);
    column->addWidget(makeHeading(tr("What do you want to know?"), 1.4));
    for (const StartCard& entry : startCards) {
        const auto text = [](const char* source) {
            return QCoreApplication::translate("StartQuestion", source);
        };
        auto* card = new CardButton(makeIcon(QString::fromLatin1(entry.icon)).pixmap(iconPx, iconPx),
                                    text(entry.title), text(entry.about), "startQuestion");
        card->setCheckable(!cityChosen_);
        connect(card, &CardButton::clicked, this,
                [this, card, question = entry.question] { chooseCard(*card, question); });
        cards_ << card;
        column->addWidget(card);
    }
    column->addStretch(1);
}

// Without a city the card waits, and the left side says what for; a second click takes it back.
void StartPage::chooseCard(const CardButton& card, StartQuestion question) {
    if (cityChosen_) return Q_EMIT asked(question);
    for (CardButton* other : cards_)
        if (other != &card) other->setChecked(false);
    heading_->setText(waiting() ? tr("Of which city?") : tr("Open a city"));
}

std::optional<StartQuestion> StartPage::waiting() const {
    for (qsizetype i = 0; i < cards_.size(); ++i)
        if (cards_[i]->isChecked()) return startCards[i].question;
    return std::nullopt;
}

// From the window's edges to the view, over the docks; at least as wide as their texts need.
void StartPage::place() {
    const QRect middle(view_.mapTo(&window_, QPoint()), view_.size());
    const int top = window_.centralWidget()->y();
    const int height = window_.statusBar()->y() - top;
    const int side = std::min(sidePx, window_.width() / 2);
    const int left = std::clamp(middle.left(), side, window_.width() / 2);
    const int right = std::clamp(window_.width() - middle.right() - 1, side, window_.width() / 2);
    setGeometry(0, top, left, height);
    questions_->setGeometry(window_.width() - right, top, right, height);
    view_.setCovered(std::max(0, left - middle.left()),
                     std::max(0, middle.right() + 1 - (window_.width() - right)));
}

bool StartPage::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest ||
        event->type() == QEvent::Move)
        place();
    return QFrame::eventFilter(watched, event);
}

void StartPage::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void StartPage::dropEvent(QDropEvent* event) {
    const QStringList files = listDroppedFiles(*event->mimeData());
    event->acceptProposedAction();
    if (!files.isEmpty()) Q_EMIT chosen(files, {});
}

}  // namespace noonmark
