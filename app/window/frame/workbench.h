#pragma once

#include <QObject>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>

#include "app/report/maps/change_scale.h"
#include "app/window/project/open_project.h"
#include "app/window/project/project_session.h"
#include "app/window/project/shown_result.h"
#include "app/window/study/job_slot.h"
#include "app/window/study/open_city.h"
#include "app/window/study/run_estimate.h"
#include "app/window/study/study_document.h"
#include "core/io/files/check_output.h"
#include "scenarios/impact/impact_text.h"
#include "scenarios/weights/score_text.h"

namespace noonmark {

/// What the window works on: one project, the city of the scenario that is shown, the question about it, its
/// latest answer. Long work runs beside the window; nothing here knows widgets.
class Workbench final : public QObject {
    Q_OBJECT
public:
    explicit Workbench(QObject* parent = nullptr);

    /// A project file, or city files that become a project without a file. What was open stays until then.
    /// `reading` says what city files do not. What is changed meanwhile is kept: then nothing is opened.
    void open(const QStringList& files, const ReadSettings& reading = {});
    /// Takes up the work that a recovery file holds, as a step of undo of the project that is open.
    void recover(const std::filesystem::path& recovery);
    /// The same of work that never had a file: it becomes the project that is open.
    void recoverUntitled(const std::filesystem::path& recovery);
    /// Answers the document's question for the scenario that is shown, or where a baseline is chosen, the
    /// difference from that. The answer before stays until then. Overtakes an answer that is being worked
    /// out.
    void run();
    /// Starts the run that longRun() announced: as it was asked for, or by the engine picked by itself.
    void runAnyway();
    void runQuicker();
    /// Studies all scenarios of which there is no study with the document's settings yet.
    void measureAll();
    /// What is shown: in words, and the files of the command line for it, into a folder. A saved result is
    /// not exported: the project file is its file.
    enum class Shown { nothing, study, comparison, score, savedResult };
    [[nodiscard]] Shown shown() const;
    /// Files that lie there are replaced as exportRules() allow; ask before: filesInTheWay().
    void exportShown(const std::filesystem::path& folder, const ChangeScale& scale);
    /// The names of files in the folder that exportShown() may replace.
    [[nodiscard]] QStringList filesInTheWay(const std::filesystem::path& folder) const;
    /// What an output may be written over, after the user was asked: never the files of the city that is
    /// open, nor its project.
    [[nodiscard]] OutputRules exportRules() const;
    /// Scores the scenario that is shown with a weight table of the project, by the document's question. The
    /// answer before stays until then.
    void runScore(const std::string& weights);
    /// Shows a kept result again, on its scenario where that is still there.
    void showSaved(const std::string& name);
    void showStudyAgain();  ///< in place of a score or a kept result
    /// The answer that is shown becomes a result of the project, when its buildings are hashed.
    void keepAnswer(const QString& name);

    /// As it is shown; null before the first. A moment behind session().city() while a change is worked in.
    [[nodiscard]] std::shared_ptr<const OpenCity> city() const { return city_; }
    /// The latest of the scenario that is shown; null: none since its buildings last changed.
    [[nodiscard]] std::shared_ptr<const Study> study() const { return study_; }
    /// The latest difference of the two that are compared; null: none, or buildings changed since.
    [[nodiscard]] std::shared_ptr<const ImpactAnswer> comparison() const { return comparison_; }
    /// The score that stands before the study; null: none, or another answer came.
    [[nodiscard]] std::shared_ptr<const ScoreAnswer> score() const { return score_; }
    /// The kept result that stands before all; likewise.
    [[nodiscard]] std::shared_ptr<const ShownResult> saved() const { return saved_; }
    /// What was shown before the buildings changed, until there is an answer of those that are shown: its
    /// figures are of other buildings. Null members: nothing.
    struct PastAnswer {
        std::shared_ptr<const Study> study;
        std::shared_ptr<const ImpactAnswer> comparison;
        std::shared_ptr<const ScoreAnswer> score;
        [[nodiscard]] bool any() const { return study || comparison || score; }
    };
    [[nodiscard]] const PastAnswer& past() const { return past_; }
    /// Studies of scenarios whose buildings have not changed since, by name.
    [[nodiscard]] std::map<std::string, std::shared_ptr<const Study>> studies();
    /// How long the latest answer took to work out, seconds.
    [[nodiscard]] double answerSeconds() const { return answerSeconds_; }

    [[nodiscard]] StudyDocument& document() { return document_; }
    [[nodiscard]] ProjectSession& session() { return session_; }
    [[nodiscard]] const ZoneGuess& zone() const { return zone_; }  ///< guessed of the city's place
    [[nodiscard]] const ViewState& openedView() const { return openedView_; }  ///< what the project came with
    [[nodiscard]] JobSlot& opening() { return opening_; }
    [[nodiscard]] JobSlot& following() { return following_; }  ///< works a change into what is shown
    [[nodiscard]] JobSlot& running() { return running_; }
    [[nodiscard]] JobSlot& reading() { return reading_; }  ///< makes a kept result ready
    [[nodiscard]] JobSlot& writing() { return writing_; }
    [[nodiscard]] JobSlot& keeping() { return keeping_; }

Q_SIGNALS:
    void cityShown();      ///< city() is another
    void projectOpened();  ///< another project, after its first city was shown
    void studyDone();
    void comparisonDone();
    void scoreDone();
    void savedShown();
    void savedReweighed();  ///< a weight table changed: kept() is up to date now, or is no more
    void studyPartial(std::shared_ptr<const noonmark::PartialField> field);  ///< of the study that runs
    /// What was asked for would take long, and waits for runAnyway() or runQuicker(). Of all its fields.
    void longRun(noonmark::RunEstimate estimate);
    void studyStopped(bool cancelled);            ///< without a result; the answer before is still there
    void failed(noonmark::Error error);           ///< work that was cancelled does not fail
    void openFailed(noonmark::Error error);       ///< or cancelled: what was open stays
    void tookUp(std::filesystem::path recovery);  ///< recover() has done it
    void noted(QString text);

private:
    struct KnownStudy {
        std::shared_ptr<const City> city;    ///< what it is of: scenarios change their names
        std::shared_ptr<const Study> study;  ///< null: still to be made
    };
    void takeProject(Result<OpenProject> opened, int version);
    void takeRecovered(Result<ProjectFile> saved);
    [[nodiscard]] StudySettings firstQuestion() const;
    void follow();
    void takeCity(Result<OpenCity> city);
    void forgetAnswers();
    void nameAnswers();
    void measure(const QString& what, std::vector<KnownStudy> wanted);
    using Start = std::function<void()>;
    void startUnlessLong(double fields, Start start);
    void runNow();
    [[nodiscard]] bool comparing() const;
    void runComparison();
    void scoreNow(const std::string& weights);
    void takeStudies(Result<std::vector<KnownStudy>> made);
    void takeKnown();
    void rename(ProjectPart part, const std::string& from, const std::string& to);
    void takeComparison(Result<ImpactAnswer> answer);
    void takeScore(Result<ScoreAnswer> answer);
    void standBack();
    void reweigh();
    using Files = Result<std::vector<std::filesystem::path>>;
    using Write = std::function<Files(const std::filesystem::path& folder)>;
    [[nodiscard]] Write whatToWrite(const ChangeScale& scale) const;
    using Keep = std::function<SavedResult(const Project&)>;
    [[nodiscard]] Keep whatToKeep() const;
    void keep(const Keep& keep, const QString& name);
    std::vector<KnownStudy> wanted();
    void tell(const Error& error);

    StudyDocument document_;
    ProjectSession session_{document_.undoStack()};
    ViewState openedView_;
    ZoneGuess zone_;
    std::shared_ptr<const OpenCity> city_;
    std::vector<KnownStudy> known_;
    std::shared_ptr<const Study> study_;
    std::shared_ptr<const ImpactAnswer> comparison_;
    std::shared_ptr<const ScoreAnswer> score_;
    std::shared_ptr<const ShownResult> saved_;
    PastAnswer past_;
    Start long_;                              ///< what longRun() announced
    std::weak_ptr<const City> comparedWith_;  ///< the city before of comparison_
    double answerSeconds_ = 0;
    JobSlot opening_;
    JobSlot following_;
    JobSlot running_;
    JobSlot reading_;
    JobSlot writing_;
    JobSlot keeping_;
};

}  // namespace noonmark
