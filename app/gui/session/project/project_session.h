#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/gui/session/project/project_changes.h"
#include "app/gui/session/project/view_state.h"
#include "app/gui/session/study/open_city.h"
#include "scenarios/project/project.h"
#include "scenarios/project/project_file.h"

// The open project: its value, file and undo steps, and its tree. ProjectSession holds the project and the
// displayed scenario; project_changes has the pure functions that edit it, ScenarioCities builds the city of
// each scenario. ProjectSaving writes the project file and its recovery file; RecoveryStore names the
// recovery file of a project that has no file yet; ViewState is the part of the window's state saved in the
// project. ProjectModel and ProjectDock show the project as a tree.
class QUndoStack;

namespace noonmark {

/// A project and the city of one of its scenarios, ready for display.
struct OpenProject {
    Project project;
    std::optional<ProjectFile> file;  ///< none: never saved
    ViewState view;
    OpenCity city;  ///< the city of view.scenario
    /// Read from a recovery file of an earlier run.
    bool recovered = false;
    ZoneGuess zone;  ///< guessed from the city's location
    /// Warnings of reading the places of a map, which are not repeated in the results of studies.
    Warnings placeWarnings;
};

/// Whether the files are a single project file, by its extension.
bool isProject(const std::vector<std::string>& files);

/// Reads a project, or city files as a project without a file; no widgets, for use in a job. If the scenario
/// of the view cannot be shown any more, the existing city is shown, with a warning.
Result<OpenProject> openProject(const std::vector<std::string>& files, const ReadSettings& settings,
                                Progress& progress, const std::stop_token& stop);

/// `loaded` with the buildings of `city`, for a scenario.
LoadedCity withCity(LoadedCity loaded, const City& city);

/// Caches the cities of scenarios. A list of edits that begins with one applied before continues from its
/// city, so that a scenario shares buildings with its base and an edit costs only itself.
class ScenarioCities {
public:
    /// Errors as of cityOf(). Repeated calls return the same city.
    Result<std::shared_ptr<const City>> cityOf(const Project& project, const std::string& scenario);

private:
    struct Made {
        std::vector<Edit> edits;
        std::shared_ptr<const City> city;
    };
    [[nodiscard]] Made nearest(const std::vector<Edit>& edits) const;

    std::shared_ptr<const City> existing_;
    std::vector<Made> made_;  // oldest first
};

/// The open project: its value and file, the displayed scenario and the baseline it is compared with. Each
/// change is a step of the window's undo stack; undoing it also goes back to the scenario in which it was
/// made. Knows no widgets and does no long work.
class ProjectSession final : public QObject {
    Q_OBJECT
public:
    explicit ProjectSession(QUndoStack& undo, QObject* parent = nullptr);  ///< `undo` must outlive it

    /// Opens another project; the caller clears the undo stack. `file`: none if the project was never saved.
    /// An invalid scenario or baseline is ignored.
    void open(Project project, std::optional<ProjectFile> file, const std::string& scenario,
              const std::string& baseline = {});

    [[nodiscard]] const Project& project() const { return now_.project; }
    [[nodiscard]] const std::optional<ProjectFile>& file() const { return file_; }
    [[nodiscard]] const std::string& scenario() const { return now_.scenario; }  ///< or existingCity
    [[nodiscard]] const std::string& baseline() const { return now_.baseline; }  ///< empty: no comparison
    [[nodiscard]] std::shared_ptr<const City> city() const { return city_; }  ///< of scenario(); never null
    /// The city of any scenario; the same object until its edits change.
    Result<std::shared_ptr<const City>> cityOf(const std::string& scenario);

    /// Makes `next` the project, as one undo step; `what` names it in the menu, `goTo` is the scenario to
    /// display then, empty: the present one. An invalid project is refused, and nothing changes.
    bool change(Project next, const QString& what, const std::string& goTo = {});
    /// Appends edits to the displayed scenario; on the existing city, creates a new scenario.
    bool addEdits(std::vector<Edit> edits, const QString& what);
    bool addLot(NamedLot lot);  ///< an empty or used name is numbered

    /// Renames a part, as one undo step. The displayed scenario and the baseline stay the same under their
    /// new names. An invalid name is refused, and nothing changes.
    bool rename(ProjectPart part, const std::string& from, const std::string& to);

    void goTo(const std::string& scenario);         ///< no undo step; unknown names are refused
    void compareWith(const std::string& scenario);  ///< the user wants the comparison; empty: none
    void setBaseline(const std::string& scenario);  ///< without asking for it; unknown names are refused

    /// Whether closing would lose work: changes since the last save; for a project without a file, changes of
    /// the project itself, not only of the study settings.
    [[nodiscard]] bool hasUnsavedWork() const;
    /// Counts changes of project and study settings: equal numbers mean that nothing changed in between.
    [[nodiscard]] int version() const { return version_; }
    /// Marks the project as recovered: work that an earlier run left unsaved.
    void setRecovered();
    /// Something was computed that is saved with the project: work that closing would lose, where the project
    /// has a file.
    void noteAnswer();
    [[nodiscard]] bool recovered() const { return recovered_; }  ///< until it is saved
    /// Records that the state of version `version` was saved in `file`.
    void setSaved(ProjectFile file, int version);

Q_SIGNALS:
    void changed();          ///< something that lists display has changed
    void unsavedChanged();   ///< hasUnsavedWork() or file() may have changed
    void cityChanged();      ///< another scenario is displayed, or its buildings changed
    void baselineChanged();  ///< another baseline, or its buildings changed
    void
    comparisonRequested();  ///< the user chose a baseline, or changed its buildings; after baselineChanged()
    /// Emitted on do, undo and redo, before changed().
    void renamed(noonmark::ProjectPart part, const std::string& from, const std::string& to);
    void refused(noonmark::Error error);

private:
    friend class ProjectCommand;
    struct State {
        Project project;
        std::string scenario = existingCity;
        std::string baseline;
    };
    /// What an undo step renames, if anything.
    struct Renaming {
        std::optional<ProjectPart> part;
        std::string from;
        std::string to;
    };
    bool push(State to, const QString& what, const Renaming& renaming);
    void apply(const State& state, const Renaming& renaming);
    void takeCity();
    bool isSound(const Project& project);
    [[nodiscard]] bool projectChanged() const;

    QUndoStack& undo_;
    State now_;
    std::optional<ProjectFile> file_;
    ScenarioCities cities_;
    std::shared_ptr<const City> city_;
    int version_ = 0;
    bool recovered_ = false;
    bool newAnswers_ = false;
};

}  // namespace noonmark
