#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <string>

#include "app/window/project/project_changes.h"
#include "app/window/project/scenario_cities.h"
#include "scenarios/project/project_file.h"

class QUndoStack;

namespace noonmark {

/// The project that is open: its value and its file, the scenario that is shown and the one it is compared
/// with. Each change of the value is a step of the window's undo stack, which goes back to the scenario that
/// it was made in. Knows no widgets and does no long work.
class ProjectSession final : public QObject {
    Q_OBJECT
public:
    explicit ProjectSession(QUndoStack& undo, QObject* parent = nullptr);  ///< `undo` outlives it

    /// Another project; the caller clears the undo stack. `file`: none for one that was never saved. A
    /// scenario or baseline that is not sound is left out.
    void open(Project project, std::optional<ProjectFile> file, const std::string& scenario,
              const std::string& baseline = {});

    [[nodiscard]] const Project& project() const { return now_.project; }
    [[nodiscard]] const std::optional<ProjectFile>& file() const { return file_; }
    [[nodiscard]] const std::string& scenario() const { return now_.scenario; }  ///< or existingCity
    [[nodiscard]] const std::string& baseline() const { return now_.baseline; }  ///< empty: no comparison
    [[nodiscard]] std::shared_ptr<const City> city() const { return city_; }  ///< of scenario(); never null
    /// Of any scenario; the same city until its edits change.
    Result<std::shared_ptr<const City>> cityOf(const std::string& scenario);

    /// The project as the next step of undo; `what` names it in the menu, `goTo` the scenario to show then,
    /// empty: the one that is shown. What is not sound is refused, and nothing changes.
    bool change(Project next, const QString& what, const std::string& goTo = {});
    /// Appends to the scenario that is shown; on the existing city a new one begins.
    bool addEdits(std::vector<Edit> edits, const QString& what);
    bool addLot(NamedLot lot);  ///< an empty or used name gets a number

    /// Another name for a part, one step of undo. The scenario that is shown and the one it is compared with
    /// stay the same under their new names. What is not sound is refused, and nothing changes.
    bool rename(ProjectPart part, const std::string& from, const std::string& to);

    void goTo(const std::string& scenario);         ///< no step of undo; unknown names are refused
    void compareWith(const std::string& scenario);  ///< empty: with nothing

    /// Whether closing would lose something: changes since the last save; of a project that has no file,
    /// changes of the project itself, not only of the question.
    [[nodiscard]] bool hasUnsavedWork() const;
    /// Counts changes of project and question: two equal numbers mean that nothing happened in between.
    [[nodiscard]] int version() const { return version_; }
    /// The project is work that an earlier run left unsaved.
    void setRecovered();
    [[nodiscard]] bool recovered() const { return recovered_; }  ///< until it is saved
    /// What was saved when the version was `version`.
    void setSaved(ProjectFile file, int version);
    /// The value that a save writes: with the window's state in it.
    [[nodiscard]] Project withView(std::map<std::string, std::string> view) const;

Q_SIGNALS:
    void changed();          ///< what lists show
    void unsavedChanged();   ///< hasUnsavedWork() or file() may be another
    void cityChanged();      ///< another scenario, or other buildings in it
    void baselineChanged();  ///< another baseline, or other buildings in it
    /// Done, undone or redone; before changed().
    void renamed(noonmark::ProjectPart part, const std::string& from, const std::string& to);
    void refused(noonmark::Error error);

private:
    friend class ProjectCommand;
    struct State {
        Project project;
        std::string scenario = existingCity;
        std::string baseline;
    };
    /// What a step of undo gave another name, if anything.
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
};

}  // namespace noonmark
