#pragma once

#include <QObject>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>

#include "app/gui/base/jobs/job_slot.h"
#include "app/gui/session/answers/element_answer.h"
#include "app/gui/session/answers/export_choice.h"
#include "app/gui/session/answers/shown_result.h"
#include "app/gui/session/project/open_project.h"
#include "app/gui/session/project/project_session.h"
#include "app/gui/session/study/open_city.h"
#include "app/gui/session/study/run_estimate.h"
#include "app/gui/session/study/study_document.h"
#include "app/report/book/book.h"
#include "app/report/scenarios/scenario_study.h"
#include "core/io/files/check_output.h"
#include "scenarios/impact/impact_text.h"
#include "scenarios/weights/score_text.h"

namespace noonmark {

/// The state behind the window: one project, the city of the displayed scenario, the study settings and the
/// latest results. Long work runs in jobs on other threads. Knows no widgets.
class Workbench final : public QObject {
    Q_OBJECT
public:
    explicit Workbench(QObject* parent = nullptr);

    /// Opens a project file, or city files as a new project without a file. The current project stays until
    /// the new one is ready. `reading` supplies what city files do not state. If the project is changed
    /// meanwhile, nothing is opened.
    void open(const QStringList& files, const ReadSettings& reading = {});
    /// Replaces the open project by the work in a recovery file, as an undo step.
    void recover(const std::filesystem::path& recovery);
    /// Opens the recovered work of a project that never had a file.
    void recoverUntitled(const std::filesystem::path& recovery);
    /// Runs the document's study for the displayed scenario, of cells or of points, or, if a baseline is
    /// chosen, the comparison with it. The previous result stays until then. Replaces a run that is in
    /// progress.
    void run();
    /// Starts the run announced by longRun(): with the chosen engine, or with the automatic engine.
    void runAnyway();
    void runQuicker();
    /// Runs the study for all scenarios that have no result with the document's settings yet.
    void measureAll();
    /// The kind of the displayed result. exportShown() writes the same files as the command line.
    enum class Shown { nothing, study, comparison, score, elements, savedResult };
    [[nodiscard]] Shown shown() const;
    /// Existing files are replaced as far as exportRules() allow; ask the user before, see filesInTheWay().
    void exportShown(const std::filesystem::path& folder, const ExportChoice& choice);
    /// Names of the files that exportShown() writes, and of those of them that the folder has already.
    /// region.geojson is always named, since whether it is written is known only then.
    [[nodiscard]] QStringList filesOf(const ExportChoice& choice);
    [[nodiscard]] QStringList filesInTheWay(const std::filesystem::path& folder,
                                            const ExportChoice& choice = {});
    /// Scenarios measured with the document's settings, in the project's order.
    [[nodiscard]] std::vector<std::string> measuredScenarios();
    /// What an export of all scenarios states beside their studies, asked for when it begins.
    using ListAnswers = std::function<std::map<std::string, ScenarioAnswers>()>;
    void setScenarioAnswers(ListAnswers answers) { scenarioAnswers_ = std::move(answers); }
    /// Which files an export may overwrite after the user agreed: never the input files of the open city, nor
    /// its project file.
    [[nodiscard]] OutputRules exportRules() const;
    /// Scores the displayed scenario with a weight table of the project and the document's settings. The
    /// previous result stays until then.
    void runScore(const std::string& weights);
    /// Shows a saved result, and its scenario if that still exists.
    void showSaved(const std::string& name);
    /// Ends the display of a score or a saved result.
    void showStudyAgain();
    /// Saves the displayed result in the project, once its buildings are hashed.
    void keepAnswer(const QString& name);

    /// The displayed city; null before the first. Lags behind session().city() while a change is prepared for
    /// display.
    [[nodiscard]] std::shared_ptr<const OpenCity> city() const { return city_; }
    /// The latest study of the displayed scenario; null if there is none since its buildings last changed.
    [[nodiscard]] std::shared_ptr<const Study> study() const { return study_; }
    /// The latest comparison of scenario and baseline; null if there is none, or if buildings have changed.
    [[nodiscard]] std::shared_ptr<const ImpactAnswer> comparison() const { return comparison_; }
    /// The score displayed instead of the study; null if there is none, or if another result replaced it.
    [[nodiscard]] std::shared_ptr<const ScoreAnswer> score() const { return score_; }
    /// The study at points displayed instead of the study; null likewise.
    [[nodiscard]] std::shared_ptr<const ElementAnswer> elements() const { return elements_; }
    /// The saved result displayed instead of the others; null if there is none, or if another result replaced
    /// it.
    [[nodiscard]] std::shared_ptr<const ShownResult> saved() const { return saved_; }
    /// Results displayed before the buildings changed, until new ones are computed. Their figures belong to
    /// the previous buildings. Null members: no such result.
    struct PastAnswer {
        std::shared_ptr<const Study> study;
        std::shared_ptr<const ImpactAnswer> comparison;
        std::shared_ptr<const ScoreAnswer> score;
        std::shared_ptr<const ElementAnswer> elements;
        [[nodiscard]] bool any() const { return study || comparison || score || elements; }
    };
    [[nodiscard]] const PastAnswer& past() const { return past_; }
    /// Studies of scenarios whose buildings have not changed since, by scenario name.
    [[nodiscard]] std::map<std::string, std::shared_ptr<const Study>> studies();
    /// A baseline is chosen that differs from the displayed scenario: run() compares the two.
    [[nodiscard]] bool comparing() const;
    /// run() measures points.
    [[nodiscard]] bool measuresElements() const { return document_.elements() && !comparing(); }
    /// Time to compute the latest result, seconds.
    [[nodiscard]] double answerSeconds() const { return answerSeconds_; }

    /// The city files opened last and how they were read; no files: the project was recovered.
    struct Source {
        QStringList files;
        ReadSettings reading;
    };
    [[nodiscard]] const Source& source() const { return source_; }
    /// For titles and suggested file names: of the project file, or else of the city files.
    [[nodiscard]] QString projectName() const;

    [[nodiscard]] StudyDocument& document() { return document_; }
    [[nodiscard]] ProjectSession& session() { return session_; }
    /// Of reading the places of the city files opened last.
    [[nodiscard]] const Warnings& placeWarnings() const { return placeWarnings_; }
    [[nodiscard]] const ZoneGuess& zone() const { return zone_; }  ///< guessed from the city's location
    [[nodiscard]] const ViewState& openedView() const { return openedView_; }  ///< read from the project file
    [[nodiscard]] JobSlot& opening() { return opening_; }
    [[nodiscard]] JobSlot& following() { return following_; }  ///< prepares a changed city for display
    [[nodiscard]] JobSlot& running() { return running_; }
    [[nodiscard]] JobSlot& reading() { return reading_; }  ///< reads a saved result
    [[nodiscard]] JobSlot& writing() { return writing_; }
    [[nodiscard]] JobSlot& keeping() { return keeping_; }

Q_SIGNALS:
    void cityShown();      ///< city() has changed
    void projectOpened();  ///< another project, after cityShown()
    void studyDone();
    void comparisonDone();
    void scoreDone();
    void elementsDone();
    void savedShown();
    void savedReweighed();  ///< a weight table changed: saved() is updated, or reset
    void studyPartial(std::shared_ptr<const noonmark::PartialField> field);  ///< of the running study
    /// The requested run would take long and waits for runAnyway() or runQuicker(). The estimate covers all
    /// its fields.
    void longRun(noonmark::RunEstimate estimate);
    void studyStopped(bool cancelled);            ///< without a result; the previous result stays
    void failed(noonmark::Error error);           ///< not emitted for cancelled work
    void openFailed(noonmark::Error error);       ///< or cancelled: the current project stays
    void tookUp(std::filesystem::path recovery);  ///< recover() has finished
    void noted(QString text);

private:
    struct KnownStudy {
        /// Identifies the study, since scenarios may be renamed.
        std::shared_ptr<const City> city;
        std::shared_ptr<const Study> study;  ///< null: not computed yet
    };
    void takeProject(Result<OpenProject> opened, int version);
    void takeRecovered(Result<ProjectFile> saved);
    [[nodiscard]] StudySettings firstQuestion() const;
    void follow();
    void takeCity(Result<OpenCity> city);
    void forgetAnswers();
    void nameAnswers();
    /// `toSave`: the figures are work of the user's that is saved with the project.
    void measure(const QString& what, std::vector<KnownStudy> wanted, bool toSave = false);
    using Start = std::function<void()>;
    void startUnlessLong(double fields, Start start);
    void runNow();
    void runComparison();
    void announceIfLong(const Result<RunEstimate>& one, double fields, const Start& start);
    void startElements();
    void measureElements();
    void takeElements(Result<ElementAnswer> answer);
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
    [[nodiscard]] Write whatToWrite(const ExportChoice& choice) const;
    [[nodiscard]] Write scenariosToWrite(const ExportChoice& choice);
    [[nodiscard]] BookSettings bookSettings(const ExportChoice& choice) const;
    using Keep = std::function<SavedResult(const Project&)>;
    [[nodiscard]] Keep whatToKeep() const;
    void keep(const Keep& keep, const QString& name);
    std::vector<KnownStudy> wanted();
    void tell(const Error& error);

    StudyDocument document_;
    ProjectSession session_{document_.undoStack()};
    Source source_;
    ViewState openedView_;
    ZoneGuess zone_;
    Warnings placeWarnings_;
    std::shared_ptr<const OpenCity> city_;
    std::vector<KnownStudy> known_;
    std::shared_ptr<const Study> study_;
    std::shared_ptr<const ImpactAnswer> comparison_;
    std::shared_ptr<const ScoreAnswer> score_;
    std::shared_ptr<const ElementAnswer> elements_;
    std::shared_ptr<const ShownResult> saved_;
    PastAnswer past_;
    ListAnswers scenarioAnswers_;
    Start long_;                              ///< the run announced by longRun()
    std::weak_ptr<const City> comparedWith_;  ///< the baseline city of comparison_
    double answerSeconds_ = 0;
    JobSlot opening_;
    JobSlot following_;
    JobSlot running_;
    JobSlot reading_;
    JobSlot writing_;
    JobSlot keeping_;
};

}  // namespace noonmark
