#include "tests/golden/window_states.h"

#include <QAbstractItemModel>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDate>
#include <QDialog>
#include <QDir>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QFile>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMenuBar>
#include <QProgressBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QSlider>
#include <QStatusBar>
#include <QTimer>
#include <QTreeView>
#include <QTreeWidget>
#include <algorithm>
#include <ctime>

#include "tests/golden/window_text.h"
#include "tests/gui/small_project.h"

namespace noonmark::golden {

namespace {

constexpr int restMs = 200;
constexpr int quietMs = 1600;           // longer than the window waits before it asks for anything by itself
constexpr int longestWaitMs = 300'000;  // for a hang
constexpr double idleShare = 0.15;      // of the time that an idle window computes, at most

/// A tower of storeys on the yard.
Edit designedTower(const std::string& id, int storeys) {
    const Footprint lot = test::square({20, 20}, 20);
    Building building{.sourceId = id, .name = id};
    building.parts.push_back({.sourceId = id, .footprint = lot, .topM = 3.5F * float(storeys)});
    return AddBuilding{std::make_shared<const Building>(std::move(building)),
                       std::make_shared<const TowerDesign>(TowerDesign{
                           "Yard", lot, {.storeys = storeys, .uses = {{"Offices", 2}, {"Homes", 0}}}})};
}

Project goldenProject() {
    Project project = test::smallProject();
    project.places.push_back({"Park", PlaceKind::park, {test::square({10, 60}, 40)}, "drawn"});
    project.places.push_back({"Far park", PlaceKind::playground, {test::square({3000, -3000}, 30)}, "drawn"});
    project.scenarios.push_back({"Tower", "", {test::newTower("New", 70)}});
    project.scenarios.push_back({"Lower", "", {designedTower("New", 8), Demolish{test::idOf(project, 1)}}});
    TimeWeights heat = makeMonthlyWeights();
    heat.name = "Heat";
    heat.intervals.erase(heat.intervals.begin(), heat.intervals.begin() + 7);  // August to December
    project.weights.push_back(heat);
    Period autumn{.start = {std::chrono::year{2026} / 9 / 1}, .days = 40, .stepMinutes = 10};
    autumn.zone = "America/New_York";
    project.periods.push_back({"Autumn", autumn});
    return project;
}

struct Rewriting {
    QRegularExpression pattern;
    QString by;
};

const std::vector<Rewriting>& rewritings() {
    static const std::vector<Rewriting> all = [] {
        const auto row = [](const char* pattern, const char* by) {
            return Rewriting{QRegularExpression(QString::fromLatin1(pattern)), QString::fromLatin1(by)};
        };
        return std::vector{row("TODAY(T|,? )\\d\\d:\\d\\d(:\\d\\d)?Z?", "TODAY"),
                           row("about (a second|[\\d.,]+ (s|min|h|days)\\b)", "TIME"),
                           row("\\b[\\d.,]+ (ms|s|seconds?)\\b", "TIME"),
                           row("(\"[a-z_]*seconds\": )(\\{[^{}]*\\}|[\\d.e-]+)", "\\1TIME"),
                           row("(\"file_sha256\": )\"\\w+\"", "\\1HASH"),
                           row("AVX-?512|AVX2|SSE4\\.2|\\b\\d+ (threads?|cores?)\\b", "MACHINE")};
    }();
    return all;
}

/// Without what differs from one run to the next: durations, the day, folders, what the machine is.
QString normalised(QString text, const QString& folder) {
    text.replace(folder, QStringLiteral("FOLDER"));
    const QDate today = QDate::currentDate();
    const QLocale english(QLocale::English);
    for (const QString& day :
         {today.toString(Qt::ISODate), english.toString(today, QStringLiteral("d MMMM yyyy")),
          english.toString(today, QStringLiteral("d MMM yyyy"))})
        text.replace(day, QStringLiteral("TODAY"));
    for (const Rewriting& rewriting : rewritings()) text.replace(rewriting.pattern, rewriting.by);
    return text;
}

/// Of the texts in a bar that are seen.
QString seenIn(const QWidget& bar) {
    QStringList texts;
    for (const QLabel* label : bar.findChildren<QLabel*>())
        if (label->isVisible()) texts << label->text();
    for (const QPushButton* button : bar.findChildren<QPushButton*>())
        if (button->isVisible()) texts << QStringLiteral("[%1]").arg(button->text());
    texts.removeAll(QString());
    return texts.join(u' ');
}

QAction* find(const QList<QAction*>& actions, const QString& text) {
    for (QAction* action : actions) {
        if (action->text().remove(u'&') == text || action->objectName() == text) return action;
        if (action->menu() == nullptr) continue;
        if (QAction* inner = find(action->menu()->actions(), text)) return inner;
    }
    return nullptr;
}

}  // namespace

WindowStates::WindowStates(QString folder) : folder_(std::move(folder)) {
    if (!QDir().mkpath(folder_)) qFatal("The folder %s cannot be made", qPrintable(folder_));
    settings_.setValue(QStringLiteral("unsavedFolder"), work_.filePath(QStringLiteral("unsaved")));
    makeProject();
    window_ = std::make_unique<MainWindow>(settings_);
    window_->time().setClock([] {
        return Instant(std::chrono::sys_days(std::chrono::year(2026) / 6 / 21) + std::chrono::hours(16));
    });
    window_->resize(1400, 1000);
    window_->show();
}

void WindowStates::makeProject() {
    if (const auto made = ProjectFile::create(file_.toStdString(), goldenProject()); !made)
        qFatal("%s", made.error().text().c_str());
}

void WindowStates::writeAll() {
    open();
    study();
    compare();
    score();
    measurePoints();
    measurePlaces();
    inspectPoint();
    review();
    reviewGlazing();
    fillScenarioTable();
    saveAndReopen();
    showSavedResults("saved result");
    changeSettings();
    changeBuildings();
}

void WindowStates::open() {
    window_->open({file_});
    write("opened");
}

void WindowStates::study() {
    enter(QStringLiteral("Scenarios"), QStringLiteral("Tower"));
    enter(QStringLiteral("Regions"), QStringLiteral("Square"));
    enter(QStringLiteral("Periods"), QStringLiteral("Autumn"));
    named<QDoubleSpinBox>("cell").setValue(4);
    press("run");
    write("studied");
    exportTo("studied");
    trigger(QStringLiteral("Save result"));
}

void WindowStates::compare() {
    trigger(QStringLiteral("compareExisting"));
    write("compared");
    exportTo("compared");
    trigger(QStringLiteral("Save result"));
}

void WindowStates::score() {
    trigger(QStringLiteral("compareExisting"));
    enter(QStringLiteral("Weight tables"), QStringLiteral("Heat"));
    press("score");
    write("scored");
    exportTo("scored");
    trigger(QStringLiteral("Save result"));
    press("wayBack");
}

void WindowStates::measurePoints() {
    choose("places", QStringLiteral("on facades"));
    press("run");
    write("points");
    exportTo("points");
    trigger(QStringLiteral("Save result"));
    choose("places", QStringLiteral("on the ground"));
}

// The days of the study are as before, so that the other states do not depend on this one.
void WindowStates::measurePlaces() {
    choose("studyKind", QStringLiteral("Sun by place"));
    enter(QStringLiteral("Periods"), QStringLiteral("Autumn"));
    press("run");
    write("sun by place");
    named<QCheckBox>("placesGrouped").click();
    named<QSlider>("placesSlider").setValue(100);
    write("sun by place grouped");
    exportTo("places");
    trigger(QStringLiteral("Save result"));
    choose("studyKind", QStringLiteral("Hours of shadow"));
    press("wayBack");
}

void WindowStates::inspectPoint() {
    window_->points().inspect({{-85, -75, 0}, {}, {0, 0, 1}});
    write("point inspected");
}

void WindowStates::review() {
    trigger(QStringLiteral("reviewByRule"));
    choose("reviewRule", QStringLiteral("ceqr"));
    press("screen");
    write("screened");
    press("runReview");
    named<QTreeWidget>("verdicts").setCurrentItem(named<QTreeWidget>("verdicts").topLevelItem(0));
    write("reviewed");
}

void WindowStates::reviewGlazing() {
    choose("reviewRule", QStringLiteral("en-17037"));
    press("runReview");
    write("reviewed glazing");
}

void WindowStates::fillScenarioTable() {
    choose("reviewRule", QStringLiteral("ceqr"));
    for (const char* button : {"measureAll", "scoreAll", "reviewAll"}) press(button);
    write("scenarios");
    exportTo("scenarios", 1);
    showDialogs();
}

void WindowStates::saveAndReopen() {
    trigger(QStringLiteral("Save project"));
    write("saved");
    window_->open({file_});
    write("reopened");
}

void WindowStates::showSavedResults(const char* state) {
    const QAbstractItemModel& model = *named<QTreeView>("projectTree").model();
    const int count = model.rowCount(nodeOf(QStringLiteral("Saved results"), {}));
    for (int row = 0; row < count; ++row) {
        const QModelIndex group = nodeOf(QStringLiteral("Saved results"), {});
        Q_EMIT named<QTreeView>("projectTree").doubleClicked(model.index(row, 0, group));
        write(state);
    }
}

/// After which results are marked: by other settings, by other weights, by other buildings.
void WindowStates::changeSettings() {
    trigger(QStringLiteral("compareExisting"));
    named<QDoubleSpinBox>("cell").setValue(5);
    write("settings changed");
}

void WindowStates::changeBuildings() {
    trigger(QStringLiteral("mode0"));  // computes nothing by itself
    auto& tree = named<QTreeView>("projectTree");
    tree.setCurrentIndex(
        tree.model()->index(0, 0, nodeOf(QStringLiteral("Scenarios"), QStringLiteral("Tower"))));
    QKeyEvent remove(QEvent::KeyPress, Qt::Key_Delete, Qt::NoModifier);
    QCoreApplication::sendEvent(&tree, &remove);
    write("aged");
    trigger(QStringLiteral("Run"));
    write("run again");
    showSavedResults("outdated result");
}

/// Of the menus: what they offer depends on what is shown.
void WindowStates::showDialogs() {
    for (const auto& [action, state] : {std::pair{"exportResults", "dialog export"},
                                        {"Export movie...", "dialog movie"},
                                        {"Export the review...", "dialog export review"}}) {
        trigger(QString::fromLatin1(action));
        write(state);
        for (QDialog* dialog : window_->findChildren<QDialog*>()) dialog->close();
    }
}

// --- What a user does

template <class T>
T& WindowStates::named(const char* name) {
    auto* found = window_->findChild<T*>(QString::fromLatin1(name));
    if (found == nullptr) qFatal("There is no %s named %s", T::staticMetaObject.className(), name);
    return *found;
}

void WindowStates::choose(const char* list, const QString& entry) {
    auto& box = named<QComboBox>(list);
    const int at = std::max(box.findText(entry), box.findData(entry));
    if (at < 0) qFatal("The list %s has no %s", list, qPrintable(entry));
    box.setCurrentIndex(at);
    Q_EMIT box.activated(at);
    settle();
}

void WindowStates::press(const char* button) {
    named<QPushButton>(button).click();
    settle();
}

void WindowStates::trigger(const QString& action) {
    QAction* found = find(window_->menuBar()->actions(), action);
    if (found == nullptr) qFatal("No menu has %s", qPrintable(action));
    found->trigger();
    settle();
}

void WindowStates::enter(const QString& group, const QString& name) {
    Q_EMIT named<QTreeView>("projectTree").doubleClicked(nodeOf(group, name));
    settle();
}

/// A node of the project tree; without a name the group itself.
QModelIndex WindowStates::nodeOf(const QString& group, const QString& name) {
    const QAbstractItemModel& model = *named<QTreeView>("projectTree").model();
    const auto childOf = [&](const QModelIndex& parent, const QString& beginning) {
        for (int row = 0; row < model.rowCount(parent); ++row)
            if (model.index(row, 0, parent).data().toString().startsWith(beginning))
                return model.index(row, 0, parent);
        qFatal("The project tree has no %s", qPrintable(beginning));
    };
    const QModelIndex found = childOf({}, group);
    return name.isEmpty() ? found : childOf(found, name);
}

/// Exports what is shown, or another subject of the dialog, with all that can be had. Files of text are
/// compared, of the others their names.
void WindowStates::exportTo(const char* name, int subject) {
    trigger(QStringLiteral("exportResults"));
    const QDir from(work_.filePath(QString::fromLatin1(name)));
    named<QComboBox>("exportSubject").setCurrentIndex(subject);
    for (const char* box : {"exportCells", "exportSheets"})
        if (named<QCheckBox>(box).isEnabled()) named<QCheckBox>(box).setChecked(true);
    named<QLineEdit>("exportFolder").setText(from.path());
    press("exportWrite");
    const QString to = QStringLiteral("%1/exported-%2").arg(folder_, QString::fromLatin1(name));
    for (const QFileInfo& file : from.entryInfoList(QDir::Files, QDir::Name)) {
        QFile text(file.filePath());
        const bool isText = QStringList{"json", "csv", "geojson"}.contains(file.suffix());
        if (!text.open(QIODevice::ReadOnly)) qFatal("%s cannot be read", qPrintable(text.fileName()));
        writeText(to + u'/' + file.fileName(), isText ? QString::fromUtf8(text.readAll()) : QString());
    }
}

// --- Waiting and writing

/// Until the window has said the same for a while, shows no progress and computes nothing.
void WindowStates::settle() {
    QElapsedTimer all, quiet;
    all.start();
    quiet.start();
    QString before;
    while (quiet.elapsed() < quietMs) {
        if (all.elapsed() > longestWaitMs) qFatal("The window does not come to rest");
        const std::clock_t computed = std::clock();
        rest();
        const bool busy = double(std::clock() - computed) / CLOCKS_PER_SEC > idleShare * restMs / 1000;
        const QList<QProgressBar*> bars = window_->findChildren<QProgressBar*>();
        QString now = describeWindow(*window_);
        if (now != before || busy || std::ranges::any_of(bars, &QWidget::isVisible)) quiet.restart();
        before = std::move(now);
    }
}

void WindowStates::rest() {
    QEventLoop loop;
    QTimer::singleShot(restMs, &loop, &QEventLoop::quit);
    QTimer often;
    QObject::connect(&often, &QTimer::timeout, [this] { listenToMessages(); });
    often.start(20);
    loop.exec();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);  // of closed dialogs
}

void WindowStates::listenToMessages() {
    const QString message = seenIn(named<QWidget>("messageBar"));
    for (const QString& seen : {message, window_->statusBar()->currentMessage()})
        if (!seen.isEmpty() && !messages_.contains(seen)) messages_ << seen;
}

void WindowStates::write(const char* name) {
    settle();
    named<QWidget>("messageBar").hide();
    window_->statusBar()->clearMessage();
    QString text = describeWindow(*window_) + QStringLiteral("\nmessages since the state before\n");
    for (const QString& message : std::exchange(messages_, {})) text += QStringLiteral("  %1\n").arg(message);
    writeText(QStringLiteral("%1/%2-%3.txt")
                  .arg(folder_)
                  .arg(++written_, 2, 10, QLatin1Char('0'))
                  .arg(QString::fromLatin1(name).replace(u' ', u'-')),
              text);
}

void WindowStates::writeText(const QString& name, const QString& text) const {
    QFile file(name);
    if (!QFileInfo(name).dir().mkpath(QStringLiteral(".")) || !file.open(QIODevice::WriteOnly))
        qFatal("%s cannot be written", qPrintable(name));
    file.write(normalised(text, work_.path()).toUtf8());
}

}  // namespace noonmark::golden
