#include "app/window/workbench.h"

#include <QFileInfo>
#include <limits>

#include "app/input/all_engines.h"
#include "app/report/study_files.h"
#include "core/progress_share.h"
#include "core/stopwatch.h"
#include "scenarios/project/keep_result.h"

namespace noonmark {

namespace {

using Paths = std::vector<std::filesystem::path>;

std::vector<std::string> textsOf(const QStringList& files) {
    std::vector<std::string> texts;
    for (const QString& file : files) texts.push_back(file.toStdString());
    return texts;
}

}  // namespace

Workbench::Workbench(QObject* parent) : QObject(parent) {
    connect(&running_, &JobSlot::started, this,
            [this](const Job& job) { connect(&job, &Job::partial, this, &Workbench::studyPartial); });
    connect(&session_, &ProjectSession::cityChanged, this, &Workbench::follow);
    connect(&session_, &ProjectSession::baselineChanged, this, [this] { comparison_.reset(); });
    connect(&session_, &ProjectSession::refused, this, &Workbench::tell);
}

void Workbench::open(const QStringList& files, const ReadSettings& reading) {
    if (files.isEmpty()) return;
    running_.cancel();
    opening_.start<OpenProject>(
        tr("Opening %1").arg(QFileInfo(files.front()).fileName()),
        [files = textsOf(files), reading](Progress& progress, std::stop_token stop) {
            return openProject(files, reading, progress, std::move(stop));
        },
        [this, version = session_.version()](Result<OpenProject> opened) {
            takeProject(std::move(opened), version);
        });
}

// What was changed since `version` was never asked about: it must not be lost.
void Workbench::takeProject(Result<OpenProject> opened, int version) {
    if (opened && session_.version() != version && session_.hasUnsavedWork())
        opened = failure("The file was not opened: the project was changed while it was read", {},
                         "Save or undo the change, then open the file again");
    if (!opened) {
        if (!isCancelled(opened.error())) Q_EMIT openFailed(opened.error());
        return;
    }
    city_ = std::make_shared<const OpenCity>(std::move(opened->city));
    openedView_ = std::move(opened->view);
    forgetAnswers();
    known_.clear();
    answerSeconds_ = std::numeric_limits<double>::infinity();  // of this city nobody knows yet
    session_.open(std::move(opened->project), std::move(opened->file), openedView_.scenario,
                  openedView_.baseline);
    following_.drop();  // the city that came along is the session's
    document_.reset(openedView_.study.value_or(firstQuestion()));
    if (opened->recovered) session_.setRecovered();
    Q_EMIT cityShown();
    Q_EMIT projectOpened();
}

// Of a project that the window has not been used on: where it wants to know.
StudySettings Workbench::firstQuestion() const {
    StudySettings settings = firstSettings(city_->loaded);
    const auto& regions = session_.project().regions;
    if (!regions.empty()) settings.region = regions.front();
    return settings;
}

void Workbench::recover(const std::filesystem::path& recovery) {
    opening_.start<ProjectFile>(
        tr("Recovering"), [recovery](Progress&, std::stop_token) { return ProjectFile::open(recovery); },
        [this](Result<ProjectFile> kept) { takeRecovered(std::move(kept)); });
}

void Workbench::takeRecovered(Result<ProjectFile> kept) {
    if (!kept) return tell(kept.error());
    const ViewState view = viewStateFrom(kept->project().view);
    if (!session_.change(kept->project(), tr("recovered work"), view.scenario)) return;
    Q_EMIT noted(tr("The unsaved work is back. Save keeps it, Undo takes it away again."));
}

void Workbench::recoverUntitled(const std::filesystem::path& recovery) {
    opening_.start<OpenProject>(
        tr("Recovering"),
        [file = recovery.string()](Progress& progress, std::stop_token stop) {
            return openProject({file}, {}, progress, std::move(stop)).map([](OpenProject opened) {
                opened.file.reset();
                opened.recovered = true;
                return opened;
            });
        },
        [this, version = session_.version()](Result<OpenProject> opened) {
            takeProject(std::move(opened), version);
        });
}

// Answers about the scenario's buildings before are no answers any more.
void Workbench::forgetAnswers() {
    running_.drop();
    study_.reset();
    comparison_.reset();
}

// The answers go at once: a run that is started before the city is shown is already of the new one.
void Workbench::follow() {
    forgetAnswers();
    if (!city_) return;
    following_.start<OpenCity>(
        tr("Showing %1").arg(QString::fromStdString(session_.scenario())),
        [shown = city_, city = session_.city()](Progress& progress, const std::stop_token& stop) {
            return shownCity(withCity(shown->loaded, *city), shown->arrays, progress, stop);
        },
        [this](Result<OpenCity> city) { takeCity(std::move(city)); });
}

void Workbench::takeCity(Result<OpenCity> city) {
    if (!city) return tell(city.error());
    city_ = std::make_shared<const OpenCity>(*std::move(city));
    takeKnown();
    Q_EMIT cityShown();
}

std::map<std::string, std::shared_ptr<const Study>> Workbench::studies() {
    std::map<std::string, std::shared_ptr<const Study>> valid;
    for (const auto& [scenario, known] : known_)
        if (const auto city = session_.cityOf(scenario); city && *city == known.city)
            valid[scenario] = known.study;
    return valid;
}

void Workbench::run() {
    if (!city_) return tell({"There is no city yet", {}, "Open a file or a sample first"});
    if (!session_.baseline().empty() && session_.baseline() != session_.scenario()) return runComparison();
    comparison_.reset();
    measure(tr("Study"), {{session_.scenario(), session_.city(), nullptr}});
}

void Workbench::measure(const QString& what, std::vector<KnownStudy> wanted) {
    using Made = std::vector<KnownStudy>;
    running_.start<Made>(
        what,
        [wanted = std::move(wanted), shown = city_, settings = document_.settings()](
            Progress& progress, std::stop_token stop) -> Result<Made> {
            Made made = wanted;
            for (std::size_t i = 0; i < made.size(); ++i) {
                ProgressShare share(progress, i, made.size());
                auto study = studyOf(withCity(shown->loaded, *made[i].city), settings,
                                     made.size() > 1 ? share : progress, stop);
                if (!study) return tl::make_unexpected(study.error());
                made[i].study = std::make_shared<const Study>(*std::move(study));
            }
            return made;
        },
        [this](Result<Made> made) { takeStudies(std::move(made)); });
}

void Workbench::takeStudies(Result<std::vector<KnownStudy>> made) {
    if (!made) {
        Q_EMIT studyStopped(isCancelled(made.error()));
        return tell(made.error());
    }
    for (const KnownStudy& one : *made) known_[one.scenario] = one;
    if (!made->empty()) answerSeconds_ = made->back().study->seconds.at("total");
    takeKnown();
    Q_EMIT studyDone();
}

// The study that is known of the scenario that is shown.
void Workbench::takeKnown() {
    const auto known = studies();
    const auto study = known.find(session_.scenario());
    study_ = study == known.end() ? nullptr : study->second;
}

std::vector<Workbench::KnownStudy> Workbench::wanted() {
    std::vector<KnownStudy> wanted;
    const auto known = studies();
    const auto want = [&](const std::string& name) {
        const auto study = known.find(name);
        if (study != known.end() && study->second->settings == document_.settings()) return;
        if (const auto city = session_.cityOf(name)) wanted.push_back({name, *city, nullptr});
    };
    want(existingCity);
    for (const Scenario& scenario : session_.project().scenarios) want(scenario.name);
    return wanted;
}

void Workbench::measureAll() {
    if (city_) measure(tr("All scenarios"), wanted());
}

void Workbench::runComparison() {
    const auto before = session_.cityOf(session_.baseline());
    if (!before) return tell(before.error());
    ImpactAnswer question{
        session_.baseline(), session_.scenario(), {document_.settings(), true}, {30, 60}, {}};
    running_.start<ImpactAnswer>(
        tr("Comparison"),
        [question, before = *before, after = session_.city()](Progress& progress, std::stop_token stop) {
            return runImpact(*before, *after, question.settings, progress, std::move(stop),
                             enginesWith(question.settings.study.engine))
                .map([&](ImpactStudy study) {
                    ImpactAnswer answer = question;
                    answer.study = std::move(study);
                    return answer;
                });
        },
        [this, watch = Stopwatch(), before = *before, after = session_.city()](Result<ImpactAnswer> answer) {
            const auto still = session_.cityOf(session_.baseline());
            if (after != session_.city() || !still || *still != before) return Q_EMIT studyStopped(false);
            if (answer) answerSeconds_ = watch.seconds();
            takeComparison(std::move(answer));
        });
}

void Workbench::takeComparison(Result<ImpactAnswer> answer) {
    if (!answer) {
        Q_EMIT studyStopped(isCancelled(answer.error()));
        return tell(answer.error());
    }
    comparison_ = std::make_shared<const ImpactAnswer>(*std::move(answer));
    Q_EMIT comparisonDone();
}

void Workbench::keepAnswer(const QString& name) {
    const std::string wanted = freeName(session_.project(), ProjectPart::result, name.toStdString());
    const QString what = tr("result %1").arg(QString::fromStdString(wanted));
    if (comparison_)
        session_.change(withResult(session_.project(), wanted, *comparison_), what);
    else if (study_)
        session_.change(withResult(session_.project(), wanted, session_.scenario(), *study_), what);
    else
        tell({"There is no result to keep yet", {}, "Press Run first"});
}

void Workbench::exportStudy(const std::filesystem::path& folder) {
    if (!study_) return tell({"There is no study to export yet", {}, "Press Run first"});
    writing_.start<Paths>(
        tr("Writing"),
        [study = study_, folder](Progress&, std::stop_token) {
            return writeStudyFiles(*study, folder, {.cellsCsv = true});
        },
        [this, folder](Result<Paths> paths) {
            if (!paths) return tell(paths.error());
            Q_EMIT noted(tr("%1 files written into %2")
                             .arg(paths->size())
                             .arg(QString::fromStdString(folder.string())));
        });
}

void Workbench::tell(const Error& error) {
    if (!isCancelled(error)) Q_EMIT failed(error);
}

}  // namespace noonmark
