#include "app/gui/frame/actions/opening_actions.h"

#include <QAction>
#include <QCursor>
#include <QDir>
#include <QFileInfo>
#include <algorithm>

#include "app/gui/base/files/file_dialogs.h"
#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/base/widgets/status_bars.h"
#include "app/gui/frame/actions/place_actions.h"
#include "app/gui/frame/actions/saving_actions.h"
#include "app/gui/session/answers/result_rows.h"
#include "app/gui/session/study/open_options.h"
#include "app/gui/session/workbench.h"
#include "app/gui/tools/photograph/photograph_actions.h"
#include "app/input/load_city.h"
#include "core/io/files/plain_file.h"
#include "core/io/settings/read_settings.h"
#include "core/study/text/height_facts_text.h"

namespace noonmark {

RecentMenu::RecentMenu(QMenu& menu, QSettings& settings) : menu_(menu), recent_(settings) { fill(); }

void RecentMenu::add(const QStringList& files, const ReadSettings& reading) {
    recent_.add(files, reading);
    fill();
}

void RecentMenu::fill() {
    menu_.clear();
    for (const QString& entry : recent_.entries()) {
        if (RecentFiles::isSampleEntry(entry)) continue;  // they have a menu of their own
        const QString reading = recent_.readingTextOf(entry);
        const QString name = RecentFiles::nameOf(entry);
        QAction* action = menu_.addAction(reading.isEmpty() ? name : tr("%1, with options").arg(name));
        action->setStatusTip(reading.isEmpty() ? entry : tr("%1, read with %2").arg(entry, reading));
        connect(action, &QAction::triggered, this,
                [this, entry] { Q_EMIT chosen(RecentFiles::filesOf(entry), recent_.readingOf(entry)); });
    }
    menu_.setEnabled(!menu_.isEmpty());
}

namespace {

LonLat findMiddle(const City& city) {
    const Box2 box = bounds(city);
    if (box.empty()) return city.frame.origin();
    return city.frame.lonLatFromLocal((glm::dvec2(box.low) + glm::dvec2(box.high)) / 2.0);
}

// How a city was read, with what is stated about the terrain that is added to it.
ReadSettings withTerrain(ReadSettings city, const ReadSettings& terrain) {
    const ReadSettings defaults;
    if (terrain.terrainShows != defaults.terrainShows) city.terrainShows = terrain.terrainShows;
    if (terrain.heightsFromSurface) city.heightsFromSurface = true;
    if (terrain.crs && !city.crs) city.crs = terrain.crs;
    return city;
}

bool isTerrain(const QString& file) {
    const auto kind = detectFileKind(file.toStdString());
    return kind && *kind == FileKind::terrain;
}

bool areTerrain(const QStringList& files) { return std::ranges::all_of(files, isTerrain); }

QStringList listFiles(const QString& folder, const QStringList& endings) {
    QStringList patterns, files;
    for (const QString& ending : endings) patterns << QStringLiteral("*.") + ending;
    for (const QFileInfo& file : QDir(folder).entryInfoList(patterns, QDir::Files, QDir::Name))
        files << file.absoluteFilePath();
    return files;
}

// Without photographs, which have the same endings.
QStringList listTerrains(const QString& folder) {
    QStringList terrains;
    for (const QString& file : listFiles(folder, endingsOf({FileKind::terrain})))
        if (isTerrain(file) && !isPhotograph({file})) terrains << file;
    return terrains;
}

QString nameOfFile(const QString& file) { return QFileInfo(file).fileName(); }

QString listFileNames(const QStringList& files) {
    constexpr qsizetype maxNames = 4;
    QStringList names;
    for (const QString& file : files.first(std::min(files.size(), maxNames))) names << nameOfFile(file);
    if (files.size() > maxNames) names << QObject::tr("and %1 more").arg(files.size() - maxNames);
    return names.join(QObject::tr(", "));
}

}  // namespace

OpeningActions::OpeningActions(Workbench& workbench, SavingActions& saving, QSettings& settings,
                               MessageBar& messages, QWidget& window)
    : workbench_(workbench),
      saving_(saving),
      messages_(messages),
      window_(window),
      samples_(tr("Open samp&le")),
      recentMenu_(tr("Open &recent")),
      recent_(recentMenu_, settings),
      options_(new OpenOptions(&window)) {
    makeActions();
    connect(&recent_, &RecentMenu::chosen, this, &OpeningActions::openWith);
    connect(options_, &OpenOptions::chosen, this, &OpeningActions::openWith);
    connect(&workbench_, &Workbench::openFailed, this, &OpeningActions::showFailure);
    connect(&saving_, &SavingActions::saved, this, [this](const QString& file) { recent_.add({file}); });
}

void OpeningActions::makeActions() {
    QAction* newProject =
        makeAction(this, tr("&New project from a city..."), QKeySequence::New,
                   tr("Footprints, CityJSON, meshes, terrain; several files are combined into one city"));
    QAction* open = makeAction(this, tr("&Open..."), QKeySequence::Open,
                               tr("A project, or city files, from which a new project is created"), "open");
    QAction* withOptions = makeAction(this, tr("Open &with options..."), QKeySequence(tr("Ctrl+Shift+O")),
                                      tr("For files without location, unit or heights"));
    for (QAction* action : {newProject, open})
        connect(action, &QAction::triggered, this, [this] { this->open(askForCity(&window_)); });
    connect(withOptions, &QAction::triggered, this, [this] {
        if (const QStringList files = askForCity(&window_); !files.isEmpty()) options_->ask(files, {});
    });
    addSample(tr("&Central Park South"), tr("The park, its streets and the towers of the case study"),
              QStringLiteral("sample:central-park-south"));
    addSample(tr("&Grid"), tr("A synthetic city of blocks and lots"), QStringLiteral("sample:grid"));
    actions_ = {newProject, open, withOptions, samples_.menuAction(), recentMenu_.menuAction()};
}

void OpeningActions::addSample(const QString& text, const QString& tip, const QString& sample) {
    QAction* action = makeAction(this, text, {}, tip);
    connect(action, &QAction::triggered, this, [this, sample] { open({sample}); });
    samples_.addAction(action);
}

QList<QAction*> OpeningActions::actions() const { return actions_; }

void OpeningActions::open(const QStringList& files) { openWith(files, {}); }

void OpeningActions::openWith(const QStringList& files, const ReadSettings& reading) {
    if (files.isEmpty()) return;
    const bool sameFiles = files == workbench_.source().files;
    if (workbench_.city() != nullptr && !sameFiles && areTerrain(files))
        return askAboutTerrain(files, reading);
    replaceBy(files, reading);
}

void OpeningActions::openFolder() {
    if (const QString folder = askForFolder(&window_, tr("Open a folder of city files")); !folder.isEmpty())
        openFilesOf(folder);
}

// A folder may be one data set (a file geodatabase, shapefiles); of any other its buildings are opened. A
// terrain may be that of roofs or of crowns above the ground: such files are listed, and the user adds one.
void OpeningActions::openFilesOf(const QString& folder) {
    const auto kind = detectFileKind(folder.toStdString());
    if (kind && *kind != FileKind::terrain) return open({folder});
    const QStringList files =
        listFiles(folder, endingsOf({FileKind::footprints, FileKind::cityJson, FileKind::mesh}));
    const QStringList terrains = listTerrains(folder);
    if (files.isEmpty())
        return messages_.showError(
            {QT_TRANSLATE_NOOP("Error", "The folder holds no buildings"), folder.toStdString(),
             terrains.isEmpty()
                 ? QT_TRANSLATE_NOOP("Error", "Choose a folder of footprints, city models or meshes")
                 : QT_TRANSLATE_NOOP("Error",
                                     "It holds terrains only: open one by Open, or choose a folder of "
                                     "footprints, city models or meshes")});
    filesOfFolder_ = files;
    terrainsOfFolder_ = terrains;
    open(files);
}

QStringList OpeningActions::terrainsBeside() const {
    const bool isOpen = !filesOfFolder_.isEmpty() && workbench_.source().files == filesOfFolder_;
    return isOpen ? terrainsOfFolder_ : QStringList();
}

// Of several the user knows which is the ground: beside it lie models of roofs and of crowns.
void OpeningActions::chooseTerrain() {
    const QStringList terrains = terrainsBeside();
    if (terrains.size() == 1) return addTerrain(terrains);
    auto* menu = new QMenu(&window_);
    menu->setObjectName(QStringLiteral("terrainsBeside"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (const QString& file : terrains)
        menu->addAction(nameOfFile(file), this, [this, file] { addTerrain({file}); });
    menu->popup(QCursor::pos());
}

// A terrain has no buildings: alone it would take the place of the city that it was meant for.
void OpeningActions::askAboutTerrain(const QStringList& files, const ReadSettings& reading) {
    messages_.showHelp(
        tr("%1 is a terrain: it holds no buildings.").arg(QFileInfo(files.front()).fileName()));
    if (canAddTerrain())
        messages_.offer(tr("Add to the city"), [this, files, reading] { addTerrain(files, reading); });
    messages_.offerSecond(tr("Open alone"), [this, files, reading] { replaceBy(files, reading); });
}

// The files of a project, and samples, are not read again.
bool OpeningActions::canAddTerrain() const {
    const QStringList& files = workbench_.source().files;
    return !workbench_.session().file() && !files.isEmpty() && !isSample(files.front().toStdString());
}

void OpeningActions::addTerrain(const QStringList& files, const ReadSettings& reading) {
    const std::string name = files.front().toStdString();
    if (workbench_.city()->city().terrain)
        return messages_.showError({QT_TRANSLATE_NOOP("Error", "The city has a terrain already"), name,
                                    QT_TRANSLATE_NOOP("Error", "Open the city without it first")});
    if (!canAddTerrain())
        return messages_.showError(
            {QT_TRANSLATE_NOOP(
                 "Error", "A terrain can be added to city files only, before they are saved as a project"),
             name, QT_TRANSLATE_NOOP("Error", "Open the city files and the terrain together")});
    const Workbench::Source source = workbench_.source();
    replaceBy(source.files + files, withTerrain(source.reading, reading));
}

void OpeningActions::replaceBy(const QStringList& files, const ReadSettings& reading) {
    saving_.whenSafe([this, files, reading] {
        messages_.hide();  // its buttons refer to the previous files
        Q_EMIT openingStarted();
        workbench_.open(files, reading);
    });
}

void OpeningActions::takeProject() {
    options_->setMiddle(findMiddle(workbench_.city()->city()));
    const Workbench::Source& source = workbench_.source();
    if (!source.files.isEmpty()) recent_.add(source.files, source.reading);
    Q_EMIT opened();
}

QStringList OpeningActions::describeGuesses() const {
    const CityRead& city = workbench_.city()->loaded.read;
    QStringList lines;
    for (const Sentence& sentence : describeHeights(city.city, city.heights))
        lines << sentenceText(sentence) + u'.';
    return lines;
}

QString OpeningActions::describeReading() const {
    const CityRead& city = workbench_.city()->loaded.read;
    QStringList facts, changes;
    for (const Sentence& fact : listFacts(city)) facts << sentenceText(fact);
    for (const ReadingChange& change : countChanges(city.warnings))
        changes << QStringLiteral("%1 %2").arg(formatCount(change.count), translated(change.kind));
    facts << tr("Changed in reading: %1")
                 .arg(changes.isEmpty() ? tr("nothing") : changes.join(QStringLiteral(", ")));
    return facts.join(QStringLiteral(". ")) + u'.';
}

void OpeningActions::showGuesses() {
    QStringList lines = describeGuesses();
    const bool areHeightsDoubtful = !lines.isEmpty();
    const QStringList terrains = terrainsBeside();
    if (!terrains.isEmpty())
        lines.prepend(tr("%1 terrain(s) in the folder are not in the city: %2.", "",
                         pluralNumber(quint64(terrains.size())))
                          .arg(formatCount(std::size_t(terrains.size())), listFileNames(terrains)));
    const ZoneGuess& zone = workbench_.zone();
    if (!zone.others.isEmpty() && !workbench_.openedView().study)
        lines << tr("The time zone %1 is a guess; %2 is also nearby.")
                     .arg(zone.zone, zone.others.join(QStringLiteral(", ")));
    const std::size_t far = workbench_.city()->arrays->mainPart.farBuildings;
    if (far > 0)
        lines << tr("%1 far building(s) left out of the first view.", "", pluralNumber(far))
                     .arg(formatCount(far));
    const auto areSamples = [](const QStringList& files) {
        return std::ranges::any_of(files, &RecentFiles::isSampleEntry);
    };
    const bool fromFiles = !workbench_.session().file() && !areSamples(workbench_.source().files);
    const std::size_t places = workbench_.session().project().places.size();
    const bool needsAttention = !lines.isEmpty() || !workbench_.placeWarnings().empty();
    if ((fromFiles && places > 0) || !workbench_.placeWarnings().empty())
        lines << describePlacesRead(places, {}, workbench_.placeWarnings());
    // The bar shows the first line alone until it is unfolded.
    if (fromFiles) lines.insert(needsAttention ? lines.size() : 0, describeReading());
    if (lines.isEmpty()) return;
    if (!needsAttention) return messages_.showNote(lines.join(u'\n'));
    messages_.showHelp(lines.join(u'\n'));
    const bool canReadAgain = !workbench_.source().files.isEmpty() && !workbench_.session().file();
    if (areHeightsDoubtful && canReadAgain) offerOptions();
    if (!terrains.isEmpty())
        messages_.offerSecond(tr("Add terrain"), [this] { chooseTerrain(); });
    else if (far > 0)
        messages_.offerSecond(tr("Zoom to all"), [this] { Q_EMIT wholeCityRequested(); });
}

// If the user stated a CRS or an anchor that does not fit, the same options dialog is offered to correct it.
void OpeningActions::showFailure(const Error& error) {
    if (isCancelled(error)) return;
    messages_.showError(error);
    const ReadSettings& reading = workbench_.source().reading;
    if (asksForPlace(error) || reading.crs || reading.meshAnchor) offerOptions();
}

void OpeningActions::offerOptions() {
    messages_.offer(tr("Open with options..."),
                    [this] { options_->ask(workbench_.source().files, workbench_.source().reading); });
}

}  // namespace noonmark
