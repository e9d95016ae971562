#include "app/gui/frame/help/help_actions.h"

#include <QApplication>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QSysInfo>
#include <QVBoxLayout>
#include <QWhatsThis>
#include <utility>

#include "app/gui/base/looks/theme.h"
#include "app/gui/base/widgets/buttons.h"
#include "app/gui/frame/actions/opening_actions.h"
#include "app/input/build_facts.h"
#include "render/view/traced_city.h"

namespace noonmark {

QString makeAboutText() {
    const QString graphics = drawsInSoftware()
                                 ? QObject::tr("Graphics: OpenGL on the processor; a graphics card is faster")
                                 : QObject::tr("Graphics: OpenGL on a graphics card");
    return QString::fromStdString(buildFactsText()).trimmed() + QLatin1Char('\n') + graphics +
           QLatin1Char('\n') +
           QObject::tr("System: %1, %2").arg(QSysInfo::prettyProductName(), QGuiApplication::platformName());
}

namespace {

/// Of the mouse, and of keys that no menu has.
struct MouseRow {
    const char* where;
    const char* what;
    const char* keys;
};

constexpr MouseRow mouseRows[] = {
    {QT_TRANSLATE_NOOP("KeySheet", "View"), QT_TRANSLATE_NOOP("KeySheet", "Rotate"),
     QT_TRANSLATE_NOOP("KeySheet", "left or middle drag")},
    {QT_TRANSLATE_NOOP("KeySheet", "View"), QT_TRANSLATE_NOOP("KeySheet", "Pan"),
     QT_TRANSLATE_NOOP("KeySheet", "right drag, Shift+drag, arrow keys")},
    {QT_TRANSLATE_NOOP("KeySheet", "View"), QT_TRANSLATE_NOOP("KeySheet", "Zoom to the cursor"),
     QT_TRANSLATE_NOOP("KeySheet", "wheel, + and -")},
    {QT_TRANSLATE_NOOP("KeySheet", "View"), QT_TRANSLATE_NOOP("KeySheet", "Menu of what is there"),
     QT_TRANSLATE_NOOP("KeySheet", "right click")},
    {QT_TRANSLATE_NOOP("KeySheet", "Buildings"), QT_TRANSLATE_NOOP("KeySheet", "Select; another too"),
     QT_TRANSLATE_NOOP("KeySheet", "click; Ctrl+click")},
    {QT_TRANSLATE_NOOP("KeySheet", "Buildings"), QT_TRANSLATE_NOOP("KeySheet", "Select all in a rectangle"),
     QT_TRANSLATE_NOOP("KeySheet", "drag with Ctrl+Shift")},
    {QT_TRANSLATE_NOOP("KeySheet", "Buildings"), QT_TRANSLATE_NOOP("KeySheet", "Change the height"),
     QT_TRANSLATE_NOOP("KeySheet", "drag the arrow, or type the height and press Enter")},
    {QT_TRANSLATE_NOOP("KeySheet", "Buildings"), QT_TRANSLATE_NOOP("KeySheet", "Deselect"),
     QT_TRANSLATE_NOOP("KeySheet", "Esc")},
    {QT_TRANSLATE_NOOP("KeySheet", "Drawing"), QT_TRANSLATE_NOOP("KeySheet", "A corner"),
     QT_TRANSLATE_NOOP("KeySheet", "click; with Shift at right angles, with Ctrl without snapping")},
    {QT_TRANSLATE_NOOP("KeySheet", "Drawing"), QT_TRANSLATE_NOOP("KeySheet", "A side of a stated length"),
     QT_TRANSLATE_NOOP("KeySheet", "type it and press Enter")},
    {QT_TRANSLATE_NOOP("KeySheet", "Drawing"), QT_TRANSLATE_NOOP("KeySheet", "Finish"),
     QT_TRANSLATE_NOOP("KeySheet", "double click, Enter or right click")},
    {QT_TRANSLATE_NOOP("KeySheet", "Drawing"),
     QT_TRANSLATE_NOOP("KeySheet", "Remove the last corner; cancel"),
     QT_TRANSLATE_NOOP("KeySheet", "Backspace; Esc")},
};

QString withoutMarks(QString text) {
    text.remove(u'&');
    while (text.endsWith(u'.')) text.chop(1);
    return text;
}

}  // namespace

KeySheet::KeySheet(const QMenuBar& menus, QWidget* parent) : QDialog(parent), table_(new QTableWidget(0, 3)) {
    setObjectName(QStringLiteral("keySheet"));
    setWindowTitle(tr("Mouse and keys"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* search = new QLineEdit;
    search->setObjectName(QStringLiteral("keySearch"));
    search->setPlaceholderText(tr("Find a key or what it does"));
    search->setToolTip(tr("Shows the rows that contain these words"));
    search->setClearButtonEnabled(true);
    connect(search, &QLineEdit::textChanged, this, &KeySheet::filter);
    table_->setHorizontalHeaderLabels({tr("Where"), tr("What"), tr("Keys, mouse")});
    table_->setAccessibleName(windowTitle());
    table_->verticalHeader()->hide();
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setAlternatingRowColors(true);
    addMouse();
    for (const QAction* menu : menus.actions())
        if (menu->menu() != nullptr) addMenu(withoutMarks(menu->text()), menu->menu()->actions());
    table_->resizeColumnsToContents();
    table_->horizontalHeader()->setStretchLastSection(true);
    auto* column = new QVBoxLayout(this);
    column->addWidget(search);
    column->addWidget(table_);
    resize(760, 620);
}

void KeySheet::add(const QString& where, const QString& what, const QString& keys) {
    const int row = table_->rowCount();
    table_->insertRow(row);
    const QString texts[] = {where, what, keys};
    for (int column = 0; column < 3; ++column)
        table_->setItem(row, column, new QTableWidgetItem(texts[column]));
}

void KeySheet::addMouse() {
    for (const MouseRow& row : mouseRows) add(tr(row.where), tr(row.what), tr(row.keys));
}

void KeySheet::addMenu(const QString& where, const QList<QAction*>& entries) {
    for (const QAction* entry : entries) {
        if (entry->menu() != nullptr) addMenu(where, entry->menu()->actions());
        QStringList keys;
        for (const QKeySequence& one : entry->shortcuts()) keys << one.toString(QKeySequence::NativeText);
        if (!keys.isEmpty()) add(where, withoutMarks(entry->text()), keys.join(QStringLiteral(", ")));
    }
}

void KeySheet::filter(const QString& words) {
    for (int row = 0; row < table_->rowCount(); ++row) {
        bool found = false;
        for (int column = 0; column < 3; ++column)
            found = found || table_->item(row, column)->text().contains(words, Qt::CaseInsensitive);
        table_->setRowHidden(row, !found);
    }
}

HelpActions::HelpActions(OpeningActions& opening, QSettings& settings, QMainWindow& window, ViewPanel& view)
    : opening_(opening),
      settings_(settings),
      window_(window),
      view_(view),
      fields_([this](const GuidePlace& place) { showGuide(place); }),
      guide_(makeAction(this, tr("User &guide"), QKeySequence::HelpContents,
                        tr("The guide, at the page about the panel in use"), "help")),
      whatsThis_(makeAction(this, tr("&What's this?"), QKeySequence::WhatsThis,
                            tr("Explains the field that is clicked next; in a field, Shift+F1"), "help")),
      keys_(makeAction(this, tr("&Mouse and keys"), {}, tr("All keys and what the mouse does, as a table"),
                       "keys")),
      start_(makeAction(this, tr("&Start page"), {}, tr("Recent projects, samples and questions"), "open")),
      about_(makeAction(this, tr("&About Noonmark"), {}, tr("Version, libraries and processor"), "about")),
      questions_(
          makeAction(this, tr("Questions"), {}, tr("What do you want to know of this city?"), "help")) {
    listQuestions();
    connect(guide_, &QAction::triggered, this,
            [this] { showGuide(findGuidePlace(QApplication::focusWidget())); });
    keys_->setShortcuts({QKeySequence(tr("Ctrl+F1")), QKeySequence(Qt::Key_Question)});
    connect(keys_, &QAction::triggered, this, &HelpActions::showKeys);
    connect(whatsThis_, &QAction::triggered, this, [] { QWhatsThis::enterWhatsThisMode(); });
    connect(start_, &QAction::triggered, this, [this] { showStart(); });
    connect(about_, &QAction::triggered, this, &HelpActions::showAbout);
    connect(&opening_, &OpeningActions::openingStarted, this, [this] {
        waiting_ = startPage_ ? startPage_->waiting() : std::nullopt;
        closeStart();
    });
    connect(
        &opening_, &OpeningActions::opened, this,
        [this] {
            if (const auto question = std::exchange(waiting_, std::nullopt)) Q_EMIT questionAsked(*question);
        },
        Qt::QueuedConnection);
}

// As the cards of the start page, which is gone once a city is open.
void HelpActions::listQuestions() {
    auto* menu = new QMenu(&window_);
    menu->setToolTipsVisible(true);
    for (const StartCard& card : listStartCards()) {
        const auto text = [](const char* source) {
            return QCoreApplication::translate("StartQuestion", source);
        };
        QAction* entry = menu->addAction(makeIcon(QString::fromLatin1(card.icon)), text(card.title));
        entry->setToolTip(text(card.about));
        connect(entry, &QAction::triggered, this, [this, question = card.question] {
            closeStart();
            Q_EMIT questionAsked(question);
        });
    }
    questions_->setObjectName(QStringLiteral("askQuestion"));
    questions_->setMenu(menu);
}

// The page follows the window, and must not outlast what it follows.
HelpActions::~HelpActions() { delete startPage_; }

void HelpActions::showStart(bool cityChosen) {
    delete startPage_;
    startPage_ = new StartPage(RecentFiles(settings_), cityChosen, window_, view_);
    connectStart(*startPage_);
    startPage_->show();
    startPage_->raise();
    startPage_->setFocus();
}

void HelpActions::closeStart() {
    if (startPage_) startPage_->close();
}

void HelpActions::connectStart(StartPage& page) {
    connect(&page, &StartPage::chosen, &opening_, &OpeningActions::openWith);
    connect(&page, &StartPage::openRequested, opening_.openAction(), &QAction::trigger);
    connect(&page, &StartPage::folderRequested, &opening_, &OpeningActions::openFolder);
    connect(&page, &StartPage::guideRequested, this, [this] { showGuide({QStringLiteral("window"), {}}); });
    connect(&page, &StartPage::tourRequested, this, &HelpActions::tourRequested);
    connect(&page, &StartPage::asked, this, [this, &page](StartQuestion question) {
        page.close();
        Q_EMIT questionAsked(question);
    });
}

// Above a modal dialog, which would keep the mouse from a guide that belongs to the window.
GuideWindow& HelpActions::showGuide(const GuidePlace& place) {
    QWidget* modal = QApplication::activeModalWidget();
    QWidget* owner = modal != nullptr ? modal : &window_;
    if (shown_ && shown_->parentWidget() != owner) delete shown_;
    if (!shown_) shown_ = new GuideWindow(owner);
    shown_->show();
    shown_->raise();
    shown_->showPage(place.page, place.section);
    return *shown_;
}

void HelpActions::showKeys() {
    delete keySheet_;
    keySheet_ = new KeySheet(*window_.menuBar(), &window_);
    keySheet_->show();
}

void HelpActions::showAbout() {
    auto* box = new QMessageBox(QMessageBox::NoIcon, tr("About Noonmark"), makeAboutText(),
                                QMessageBox::Close, &window_);
    box->setObjectName(QStringLiteral("about"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextInteractionFlags(Qt::TextSelectableByMouse);
    box->open();
}

}  // namespace noonmark
