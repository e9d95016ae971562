#include "app/gui/session/workbench.h"

#include <QFileInfo>
#include <algorithm>
#include <limits>

#include "app/gui/base/files/file_dialogs.h"
#include "app/gui/base/widgets/name_text.h"
#include "app/gui/session/project/recent_files.h"
#include "scenarios/impact/impact_text.h"

namespace noonmark {

namespace {

std::vector<std::string> textsOf(const QStringList& files) {
    std::vector<std::string> texts;
    for (const QString& file : files) texts.push_back(file.toStdString());
    return texts;
}

}  // namespace

Workbench::Workbench(QObject* parent) : QObject(parent) {
    connect(&running_, &JobSlot::started, this, [this](const Job& job) {
        connect(&job, &Job::partial, this, [this](const std::shared_ptr<const PartialField>& field) {
            const bool isShown = runningOn_.empty() || runningOn_.front() == session_.city();
            if (isShown) Q_EMIT studyPartial(field);
        });
    });
    connect(&session_, &ProjectSession::cityChanged, this, &Workbench::follow);
    connect(&session_, &ProjectSession::baselineChanged, this, [this] {
        if (contentOf<ImpactAnswer>(past_)) past_.reset();
        if (!following_.busy()) findBase();
    });
    connect(&session_, &ProjectSession::changed, this, &Workbench::updateAnswers);
    connect(&session_, &ProjectSession::changed, this, &Workbench::findOutdated);
    connect(&session_, &ProjectSession::refused, this, &Workbench::report);
}

void Workbench::open(const QStringList& files, const ReadSettings& reading) {
    if (files.isEmpty()) return;
    source_ = {files, reading};
    running_.cancel();
    opening_.start<OpenProject>(
        tr("Opening %1").arg(QFileInfo(files.front()).fileName()),
        [files = textsOf(files), reading](Progress& progress, const std::stop_token& stop) {
            return openProject(files, reading, progress, stop);
        },
        [this, version = session_.version()](Result<OpenProject> opened) {
            adoptProject(std::move(opened), version);
        });
}

// Refuses to replace changes made since `version`: the user was not asked about them.
void Workbench::adoptProject(Result<OpenProject> opened, int version) {
    if (opened && session_.version() != version && session_.hasUnsavedWork())
        opened = failure(
            QT_TRANSLATE_NOOP("Error", "The file was not opened: the project was changed while it was read"),
            {}, QT_TRANSLATE_NOOP("Error", "Save or undo the change, then open the file again"));
    if (!opened) return Q_EMIT openFailed(opened.error());
    city_ = std::make_shared<const OpenCity>(std::move(opened->city));
    openedView_ = std::move(opened->view);
    zone_ = std::move(opened->zone);
    placeWarnings_ = std::move(opened->placeWarnings);
    running_.drop();
    forgetAnswers();
    past_.reset();
    pastOf_.reset();
    shownOf_ = {};
    studies_.clear();
    comparison_ = {};
    measured_ = takeMeasured(opened->project);
    named_.clear();
    outdated_.clear();
    compared_ = {};
    saving_.drop();
    answerSeconds_ = std::numeric_limits<double>::infinity();  // not known for this city yet
    session_.open(std::move(opened->project), std::move(opened->file), openedView_.scenario,
                  openedView_.baseline);
    following_.drop();  // opened->city is already the session's city
    document_.reset(openedView_.study.value_or(firstQuestion()), openedView_.elements);
    if (opened->recovered) session_.setRecovered();
    Q_EMIT cityShown();
    Q_EMIT projectOpened();
}

// The initial settings for a project without window state: its first region, if it has one.
StudySettings Workbench::firstQuestion() const {
    StudySettings settings = firstSettings(city_->loaded, zone_);
    const auto& regions = session_.project().regions;
    if (!regions.empty()) settings.region = regions.front();
    return settings;
}

void Workbench::recover(const std::filesystem::path& recovery) {
    opening_.start<ProjectFile>(
        tr("Recovering"), [recovery](Progress&, std::stop_token) { return ProjectFile::open(recovery); },
        [this](Result<ProjectFile> saved) { adoptRecovered(std::move(saved)); });
}

void Workbench::adoptRecovered(Result<ProjectFile> saved) {
    if (!saved) return report(saved.error());
    Project project = saved->project();
    MeasuredAnswers measured = takeMeasured(project);
    const ViewState view = parseViewState(project.view);
    if (!session_.change(std::move(project), tr("recover unsaved changes"), view.scenario)) return;
    measured_ = std::move(measured);
    named_.clear();
    findOutdated();
    Q_EMIT recovered(saved->path());
    Q_EMIT noted(tr("Unsaved changes recovered. Save keeps them, Undo discards them."));
}

void Workbench::recoverUntitled(const std::filesystem::path& recovery) {
    source_ = {};
    opening_.start<OpenProject>(
        tr("Recovering"),
        [file = recovery.string()](Progress& progress, const std::stop_token& stop) {
            return openProject({file}, {}, progress, stop).map([](OpenProject opened) {
                opened.file.reset();
                opened.recovered = true;
                return opened;
            });
        },
        [this, version = session_.version()](Result<OpenProject> opened) {
            adoptProject(std::move(opened), version);
        });
}

// What runs goes on while the scenarios that it measures are there: another one may be displayed meanwhile.
bool Workbench::isRunStillValid() {
    return !runningOn_.empty() && std::ranges::none_of(runningOn_, [this](const auto& city) {
        return city && scenarioOf(city).empty();
    });
}

// Answers about the scenario's previous buildings are no longer valid.
void Workbench::forgetAnswers() {
    reading_.drop();
    study_.reset();
    base_.reset();
    front_.reset();
}

// Answers are forgotten at once: a run started before the city is displayed already uses the new city.
void Workbench::follow() {
    if (const SharedAnswer shown = answer()) {
        past_ = shown;
        pastOf_ = front_ ? std::optional(shownOf_) : std::nullopt;
    }
    if (!isRunStillValid()) running_.drop();
    forgetAnswers();
    if (!city_) return;
    following_.start<OpenCity>(
        tr("Showing %1").arg(scenarioName(session_.scenario())),
        [shown = city_, city = session_.city()](Progress& progress, const std::stop_token& stop) {
            return shownCity(withCity(shown->loaded, *city), shown->arrays, shown->crowns, progress, stop);
        },
        [this](Result<OpenCity> city) { adoptCity(std::move(city)); });
}

void Workbench::adoptCity(Result<OpenCity> city) {
    if (!city) return report(city.error());
    city_ = std::make_shared<const OpenCity>(*std::move(city));
    if (past_ && pastOf_ == citiesShown()) front_ = std::exchange(past_, nullptr);  // the change was undone
    findBase();
    Q_EMIT cityShown();
}

QString Workbench::projectName() const {
    const auto& file = session_.file();
    QString name = file ? QString::fromStdString(file->path().filename().string())
                        : RecentFiles::nameOf(source_.files.join(QLatin1Char('\n')));
    name.remove(QStringLiteral("sample:"));
    name.remove(QLatin1String(projectEnding));
    name = withoutEndings(name);
    return name.isEmpty() ? tr("Untitled") : name;
}

void Workbench::report(const Error& error) {
    if (!isCancelled(error)) Q_EMIT failed(error);
}

}  // namespace noonmark
