#include "app/gui/session/project/project_session.h"

#include <fmt/format.h>
#include <QUndoStack>
#include <algorithm>

#include "app/input/load_city.h"
#include "app/input/load_project.h"

namespace noonmark {

namespace {

void goToScenario(OpenProject& opened, LoadedCity& loaded) {
    const auto edited = cityOf(opened.project, opened.view.scenario);
    if (edited) return void(loaded.read.city = edited->city);
    loaded.read.warnings.push_back({WarningKind::leftOut, edited.error().what, edited.error().where});
    opened.view.scenario = existingCity;
}

Result<LoadedCity> readProjectFile(const std::string& file, OpenProject& opened, Progress& progress,
                                   const std::stop_token& stop) {
    progress.report(0.1, "reading the project");
    auto disk = ProjectFile::open(file);
    if (!disk) return tl::make_unexpected(disk.error());
    opened.project = withLoadedPhotograph(disk->project(), opened.placeWarnings, progress, stop);
    opened.view = parseViewState(opened.project.view);
    opened.file = *std::move(disk);
    LoadedCity loaded = loadProjectCity(opened.project, file);
    goToScenario(opened, loaded);
    return loaded;
}

// The map's places come with it, as on the command line. A map whose places cannot be read is still a city.
Result<void> readMapPlaces(const std::vector<std::string>& files, OpenProject& opened, Progress& progress,
                           const std::stop_token& stop) {
    auto read = loadCityPlaces(files, {}, opened.project.city->frame, progress, stop);
    if (!read && isCancelled(read.error())) return tl::make_unexpected(read.error());
    if (!read) {
        opened.placeWarnings.push_back({WarningKind::leftOut, read.error().what, read.error().where});
        return {};
    }
    opened.project.places = std::move(read->places);
    opened.placeWarnings = std::move(read->warnings);
    return {};
}

/// Streets, parks and water of the map; a map without them is still a city.
Result<void> readMapContext(const std::vector<std::string>& files, OpenProject& opened, Progress& progress,
                            const std::stop_token& stop) {
    auto read = loadCityContext(files, opened.project.city->frame, progress, stop);
    if (!read && isCancelled(read.error())) return tl::make_unexpected(read.error());
    if (!read) {
        opened.placeWarnings.push_back({WarningKind::leftOut, read.error().what, read.error().where});
        return {};
    }
    City city = *opened.project.city;
    city.context = joinContext(nullptr, std::move(read->context));
    opened.project.city = std::make_shared<const City>(std::move(city));
    return {};
}

Result<LoadedCity> readCityFiles(const std::vector<std::string>& files, const ReadSettings& settings,
                                 OpenProject& opened, Progress& progress, const std::stop_token& stop) {
    return loadCity(files, settings, progress, stop).and_then([&](LoadedCity loaded) -> Result<LoadedCity> {
        opened.project = projectOf(loaded);
        if (auto read = readMapPlaces(files, opened, progress, stop); !read)
            return tl::make_unexpected(read.error());
        if (auto read = readMapContext(files, opened, progress, stop); !read)
            return tl::make_unexpected(read.error());
        loaded.read.city = *opened.project.city;
        return loaded;
    });
}

}  // namespace

bool isProject(const std::vector<std::string>& files) {
    return files.size() == 1 && isProjectFile(files.front());
}

Result<OpenProject> openProject(const std::vector<std::string>& files, const ReadSettings& settings,
                                Progress& progress, const std::stop_token& stop) {
    OpenProject opened;
    auto loaded = isProject(files) ? readProjectFile(files.front(), opened, progress, stop)
                                   : readCityFiles(files, settings, opened, progress, stop);
    if (!loaded) return tl::make_unexpected(loaded.error());
    // Of a scenario, the arrays are those of the existing city: what is demolished shows as outlines.
    std::shared_ptr<const CityArrays> existing;
    if (opened.view.scenario != existingCity && opened.project.city)
        existing = std::make_shared<const CityArrays>(makeArrays(*opened.project.city));
    opened.zone = findNearestZone(loaded->read.city.frame.origin());
    return shownCity(*std::move(loaded), std::move(existing), nullptr, progress, stop)
        .map([&](OpenCity city) {
            opened.city = std::move(city);
            return std::move(opened);
        });
}

LoadedCity withCity(LoadedCity loaded, const City& city) {
    loaded.read.city = city;
    return loaded;
}

namespace {

constexpr std::size_t maximum = 64;  // cities cached; each holds its own list of pointers

bool beginsWith(const std::vector<Edit>& edits, const std::vector<Edit>& first) {
    return first.size() <= edits.size() && std::equal(first.begin(), first.end(), edits.begin());
}

}  // namespace

ScenarioCities::Made ScenarioCities::nearest(const std::vector<Edit>& edits) const {
    Made best{{}, existing_};
    for (const Made& made : made_)
        if (made.edits.size() > best.edits.size() && beginsWith(edits, made.edits)) best = made;
    return best;
}

Result<std::shared_ptr<const City>> ScenarioCities::cityOf(const Project& project,
                                                           const std::string& scenario) {
    if (existing_ != project.city) made_.clear();
    existing_ = project.city;
    const auto edits = collectEdits(project.scenarios, scenario);
    if (!edits) return tl::make_unexpected(edits.error());
    const Made from = nearest(*edits);
    if (from.edits.size() == edits->size()) return from.city;
    const auto rest = std::span(*edits).subspan(from.edits.size());
    auto edited = applyEdits(*from.city, rest);
    // Applies all edits again from the first, so that the error names the right one.
    if (!edited)
        return noonmark::cityOf(project, scenario).map([](EditedCity all) {
            return std::make_shared<const City>(std::move(all.city));
        });
    made_.push_back({*edits, std::make_shared<const City>(std::move(edited->city))});
    if (made_.size() > maximum) made_.erase(made_.begin());
    return made_.back().city;
}

// Holds the project before and after; both share what did not change.
class ProjectCommand final : public QUndoCommand {
public:
    ProjectCommand(ProjectSession& session, ProjectSession::State to, const QString& what,
                   ProjectSession::Renaming renaming)
        : QUndoCommand(what),
          session_(session),
          from_(session.now_),
          to_(std::move(to)),
          renaming_(std::move(renaming)) {}

    void undo() override { session_.apply(from_, {renaming_.part, renaming_.to, renaming_.from}); }
    void redo() override { session_.apply(to_, renaming_); }

private:
    ProjectSession& session_;
    ProjectSession::State from_;
    ProjectSession::State to_;
    ProjectSession::Renaming renaming_;
};

ProjectSession::ProjectSession(QUndoStack& undo, QObject* parent)
    : QObject(parent), undo_(undo), city_(now_.project.city) {
    connect(&undo_, &QUndoStack::indexChanged, this, [this] {
        ++version_;
        Q_EMIT unsavedChanged();
    });
    connect(&undo_, &QUndoStack::cleanChanged, this, &ProjectSession::unsavedChanged);
}

void ProjectSession::open(Project project, std::optional<ProjectFile> file, const std::string& scenario,
                          const std::string& baseline) {
    now_ = {std::move(project), existingCity, {}};
    file_ = std::move(file);
    recovered_ = newAnswers_ = false;
    if (cityOf(scenario)) now_.scenario = scenario;
    if (!baseline.empty() && cityOf(baseline)) now_.baseline = baseline;
    takeCity();
    ++version_;
    Q_EMIT changed();
    Q_EMIT unsavedChanged();
}

Result<std::shared_ptr<const City>> ProjectSession::cityOf(const std::string& scenario) {
    return cities_.cityOf(now_.project, scenario);
}

bool ProjectSession::isSound(const Project& project) {
    Result<void> sound = validate(project);
    for (const Scenario& scenario : project.scenarios)
        if (sound) sound = cities_.cityOf(project, scenario.name).map([](const auto&) {});
    if (!sound) Q_EMIT refused(sound.error());
    return bool(sound);
}

bool ProjectSession::change(Project next, const QString& what, const std::string& goTo) {
    return push({std::move(next), goTo.empty() ? now_.scenario : goTo, now_.baseline}, what, {});
}

bool ProjectSession::push(State to, const QString& what, const Renaming& renaming) {
    if (!isSound(to.project)) return false;
    undo_.push(new ProjectCommand(*this, std::move(to), what, renaming));
    return true;
}

bool ProjectSession::rename(ProjectPart part, const std::string& from, const std::string& to) {
    auto next = noonmark::renameIn(now_.project, part, from, to);
    if (!next) {
        Q_EMIT refused(next.error());
        return false;
    }
    const bool shown = part == ProjectPart::scenario && now_.scenario == from;
    return push({*std::move(next), shown ? to : now_.scenario, now_.baseline},
                tr("rename %1").arg(QString::fromStdString(from)), {part, from, to});
}

bool ProjectSession::addEdits(std::vector<Edit> edits, const QString& what) {
    if (edits.empty()) return false;
    Project next = now_.project;
    std::string target = now_.scenario;
    if (target == existingCity) {
        target = nextProposal(next.scenarios);
        next = withScenario(std::move(next), target, {});
    }
    for (Scenario& scenario : next.scenarios)
        if (scenario.name == target) scenario.edits.insert(scenario.edits.end(), edits.begin(), edits.end());
    return change(std::move(next), what, target);
}

bool ProjectSession::addLot(NamedLot lot) {
    Project next = now_.project;
    lot.name = freeName(next, ProjectPart::lot, lot.name.empty() ? "Lot" : lot.name);
    const QString what = tr("add lot %1").arg(QString::fromStdString(lot.name));
    next.lots.push_back(std::move(lot));
    return change(std::move(next), what);
}

void ProjectSession::goTo(const std::string& scenario) {
    if (scenario == now_.scenario) return;
    if (const auto city = cityOf(scenario); !city) return Q_EMIT refused(city.error());
    State state = now_;
    state.scenario = scenario;
    apply(state, {});
}

void ProjectSession::compareWith(const std::string& scenario) {
    if (scenario == now_.baseline) return;
    setBaseline(scenario);
    if (scenario == now_.baseline) Q_EMIT comparisonRequested();
}

void ProjectSession::setBaseline(const std::string& scenario) {
    if (scenario == now_.baseline) return;
    if (!scenario.empty())
        if (const auto city = cityOf(scenario); !city) return Q_EMIT refused(city.error());
    now_.baseline = scenario;
    Q_EMIT changed();
    Q_EMIT baselineChanged();
}

// If the displayed scenario no longer exists (undone, deleted), the existing city is displayed; if the
// baseline no longer exists, there is none.
void ProjectSession::apply(const State& state, const Renaming& renaming) {
    const auto before = cityOf(now_.baseline).value_or(nullptr);
    const bool follows = renaming.part == ProjectPart::scenario && now_.baseline == renaming.from;
    const std::string baseline = follows ? renaming.to : now_.baseline;
    now_ = state;
    now_.baseline = baseline;
    if (!cityOf(now_.scenario)) now_.scenario = existingCity;
    const auto after = cityOf(baseline).value_or(nullptr);
    if (!after) now_.baseline.clear();
    if (renaming.part) Q_EMIT renamed(*renaming.part, renaming.from, renaming.to);
    takeCity();
    Q_EMIT changed();
    if (after == before) return;
    Q_EMIT baselineChanged();
    Q_EMIT comparisonRequested();
}

void ProjectSession::takeCity() {
    std::shared_ptr<const City> city = cityOf(now_.scenario).value_or(now_.project.city);
    if (city == city_) return;
    city_ = std::move(city);
    Q_EMIT cityChanged();
}

// Looks at commands and at those inside a macro.
bool ProjectSession::projectChanged() const {
    const auto changes = [](const QUndoCommand* command, const auto& self) -> bool {
        if (dynamic_cast<const ProjectCommand*>(command) != nullptr) return true;
        for (int i = 0; i < command->childCount(); ++i)
            if (self(command->child(i), self)) return true;
        return false;
    };
    for (int i = 0; i < undo_.index(); ++i)
        if (changes(undo_.command(i), changes)) return true;
    return false;
}

bool ProjectSession::hasUnsavedWork() const {
    return recovered_ || (newAnswers_ && file_) || (!undo_.isClean() && (file_ || projectChanged()));
}

void ProjectSession::noteAnswer() {
    newAnswers_ = true;
    ++version_;
    Q_EMIT unsavedChanged();
}

void ProjectSession::setRecovered() {
    recovered_ = true;
    Q_EMIT unsavedChanged();
}

void ProjectSession::setSaved(ProjectFile file, int version) {
    file_ = std::move(file);
    recovered_ = false;
    if (version == version_) {
        newAnswers_ = false;
        undo_.setClean();
    } else {
        undo_.resetClean();
    }
    Q_EMIT unsavedChanged();
}

}  // namespace noonmark
