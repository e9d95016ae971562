#pragma once

#include <QObject>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <set>

#include "app/gui/base/jobs/job.h"
#include "app/gui/session/answers/export_choice.h"
#include "app/gui/session/answers/measured_answers.h"
#include "app/gui/session/project/project_session.h"
#include "app/gui/session/study/open_city.h"
#include "app/gui/session/study/run_estimate.h"
#include "app/gui/session/study/study_document.h"
#include "app/questions/question.h"
#include "app/report/scenarios/scenario_study.h"

namespace noonmark {

struct PlaceContributions;

/// The state behind the window: one project, the city of the displayed scenario, the study settings and the
/// answer that is displayed. Long work runs in jobs on other threads. Knows no widgets.
///
/// The answer displayed is the one in front: the points, the score, the review or the saved result that was
/// asked for last; without one, that to the document's question: the comparison with the baseline, or the
/// study.
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

    /// Asks the document's question of the displayed scenario: a comparison if a baseline is chosen, else
    /// points or cells. The previous answer stays until then. Replaces a run that is in progress.
    void run();
    /// As run(), without being asked by the user: its answer is saved with the project, but is no unsaved
    /// work.
    void runAgain();
    /// The user waits for a run.
    [[nodiscard]] bool isAwaited() const { return running_.busy() && !again_; }
    /// What can be asked, for saved results; the questions and their list must outlive the workbench.
    void setQuestions(Questions questions) { questions_ = questions; }
    [[nodiscard]] Questions questions() const { return questions_; }
    /// Asks a question, which must outlive the workbench. `weights`: the name of the table of a score.
    void ask(const Question& question, const std::string& weights = {});
    /// Asks for the score of the displayed scenario with a weight table of the project.
    void runScore(const std::string& weights) { ask(scoreQuestion(), weights); }
    /// Asks how much sun places get in the displayed scenario, and what changes against the baseline if one
    /// is chosen: also in all other scenarios if they are wanted. The study of `settings` is the document's,
    /// without its region.
    void runByPlace(std::vector<Place> places, const SunByPlaceSettings& settings, bool allScenarios = false);
    /// If nothing is compared yet: chooses the existing city as the baseline, and displays the last scenario
    /// if none is. Does nothing without scenarios.
    void compareAnyScenario();
    /// The cities that it measures, the baseline first.
    [[nodiscard]] std::vector<std::shared_ptr<const City>> listPlaceCities(bool allScenarios);
    struct Adopting {
        bool isWork = true;   ///< the user asked for it: it is unsaved work
        bool isShown = true;  ///< displayed, too, unless its buildings have changed
    };
    /// Takes an answer to a question that was asked elsewhere, by a dock that has more to say about it: it is
    /// listed, saved and exported as all others.
    void adopt(const KnownAnswer& known, const Adopting& how);
    /// Starts the run announced by longRun(): with the chosen engine, or with the automatic engine.
    void runAnyway();
    void runQuicker();
    /// Runs the study for all scenarios that have no result with the document's settings yet.
    void measureAll();
    /// The same with each month by itself, which the document's settings ask for from then on.
    void measureAllByMonth();

    /// The displayed answer; null if there is none since the buildings last changed.
    [[nodiscard]] std::shared_ptr<const Answer> answer() const { return front_ ? front_ : base_; }
    /// The one that returns when the display of that in front ends; null: none.
    [[nodiscard]] std::shared_ptr<const Answer> behind() const { return base_; }
    /// Its content, if it is a T: Study, ImpactAnswer, ScoreAnswer, ElementAnswer, SavedContent; else null.
    template <class T>
    [[nodiscard]] std::shared_ptr<const T> answerAs() const {
        return contentOf<T>(answer());
    }
    /// There is another answer behind the displayed one, or the displayed one is not that of Run.
    [[nodiscard]] bool canShowStudyAgain() const;
    /// Ends the display of the answer in front.
    void showStudyAgain();
    /// The latest answers, oldest first, to each question the last, without those that the user has saved
    /// under a name. They are saved with the project.
    [[nodiscard]] MeasuredAnswers measured() const;
    /// The one that has been saved under this name in this session; null: none.
    [[nodiscard]] std::shared_ptr<const MeasuredAnswer> measuredSavedAs(const std::string& name) const;
    /// The name under which the displayed answer is saved; empty: under none.
    [[nodiscard]] std::string savedName() const;
    /// The latest answer about the buildings of a scenario as they are now to the question of another answer
    /// about the ground, of a comparison to that of a study; null: none in this session.
    [[nodiscard]] std::shared_ptr<const Answer> findAnswer(const std::string& scenario, const Answer& same);
    /// Shows one of them, in its scenario; where its buildings have changed since, as past(). One that was
    /// read from the project file is shown as a saved result.
    void showMeasured(const MeasuredAnswer& measured);
    [[nodiscard]] std::shared_ptr<const MeasuredAnswer> measuredShown() const;  ///< null: none of them
    /// Whether the buildings, or the files that they were read from, have changed since. Of results in the
    /// project file this becomes known some time after a change: measuredUpdated().
    [[nodiscard]] bool isOutdated(const MeasuredAnswer& measured);
    /// Whether the places that the displayed sun by place is of have changed since, been renamed or removed.
    [[nodiscard]] bool havePlacesChanged() const;
    [[nodiscard]] bool isOutdated(const SavedResult& result) const { return outdated_.contains(result.name); }
    /// The answer that was displayed before the buildings changed, until a new one is computed. Its figures
    /// belong to the previous buildings. Null: none.
    [[nodiscard]] std::shared_ptr<const Answer> past() const { return past_; }
    /// Run would give an answer of the kind that is already there.
    [[nodiscard]] bool isAnswered() const;
    /// The latest study of the displayed scenario, displayed or not; null if there is none since its
    /// buildings last changed.
    [[nodiscard]] std::shared_ptr<const Study> study() const { return study_; }
    /// Studies of scenarios whose buildings have not changed since, by scenario name.
    [[nodiscard]] std::map<std::string, std::shared_ptr<const Study>> studies();
    /// Scenarios measured with the document's settings, in the project's order.
    [[nodiscard]] std::vector<std::string> measuredScenarios();
    /// A baseline is chosen that differs from the displayed scenario: run() compares the two.
    [[nodiscard]] bool comparing() const;
    /// run() measures points.
    [[nodiscard]] bool measuresElements() const { return document_.elements() && !comparing(); }
    /// Time to compute the latest answer of a run, seconds.
    [[nodiscard]] double answerSeconds() const { return answerSeconds_; }

    /// Shows a saved result, and its scenario if that still exists.
    void showSaved(const std::string& name);
    /// Saves the displayed answer in the project, once its buildings are hashed.
    void saveAnswer(const QString& name);

    /// Attaches what buildings take from a place to the displayed answer, in all lists that have it, if its
    /// question keeps such.
    void attachToAnswer(ContributionTable of);
    /// States the displayed answer with other hours of sun a day that are enough, in all lists that have it;
    /// does nothing where it does not depend on them, or its cells are not known.
    void setEnough(double hours);

    /// Finds the command line that asks the same as the displayed answer; costs a hash of its files.
    /// With the options that draw the same as `drawn`.
    void findCommand(const AnswerFiles& drawn);

    /// Writes the same files as the command line. Existing ones are replaced as far as exportRules() allow;
    /// ask the user before, see listExistingFiles().
    void exportShown(const std::filesystem::path& folder, const ExportChoice& choice);
    /// Names of the files that exportShown() writes, and of those of them that the folder has already.
    /// region.geojson is always named, since whether it is written is known only then.
    [[nodiscard]] QStringList filesOf(const ExportChoice& choice);
    [[nodiscard]] bool hasSheets(const ExportChoice& choice);  ///< a PDF whose name may be chosen
    /// The sheets among those files.
    [[nodiscard]] SheetsToMake sheetsOf(const ExportChoice& choice);
    [[nodiscard]] QStringList listExistingFiles(const std::filesystem::path& folder,
                                                const ExportChoice& choice = {});
    /// What an export of all scenarios states beside their studies, asked for when it begins.
    using ListAnswers = std::function<std::map<std::string, ScenarioAnswers>()>;
    void setScenarioAnswers(ListAnswers answers) { scenarioAnswers_ = std::move(answers); }
    /// Writes the table of scenarios as CSV, for an export of it.
    using TableText = std::function<std::string()>;
    void setScenarioTable(TableText text) { scenarioTable_ = std::move(text); }
    /// Whether that has scores, verdicts, impacts or sun of places, measured or not.
    [[nodiscard]] bool hasScenarioAnswers() const;
    /// What an export of a place writes: its contributions in study(); null: there is none.
    using FindPlace = std::function<std::shared_ptr<const PlaceContributions>()>;
    void setPlaceShown(FindPlace find) { placeShown_ = std::move(find); }
    [[nodiscard]] std::shared_ptr<const PlaceContributions> placeShown() const {
        return placeShown_ ? placeShown_() : nullptr;
    }
    /// Which files an export may overwrite after the user agreed: never the input files of the open city, nor
    /// its project file.
    [[nodiscard]] OutputRules exportRules() const;

    /// The displayed city; null before the first. Lags behind session().city() while a change is prepared for
    /// display.
    [[nodiscard]] std::shared_ptr<const OpenCity> city() const { return city_; }
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
    /// Warnings of reading the places of the city files opened last.
    [[nodiscard]] const Warnings& placeWarnings() const { return placeWarnings_; }
    [[nodiscard]] const ZoneGuess& zone() const { return zone_; }  ///< guessed from the city's location
    [[nodiscard]] const ViewState& openedView() const { return openedView_; }  ///< read from the project file
    [[nodiscard]] JobSlot& opening() { return opening_; }
    [[nodiscard]] JobSlot& following() { return following_; }  ///< prepares a changed city for display
    [[nodiscard]] JobSlot& running() { return running_; }
    [[nodiscard]] JobSlot& reading() { return reading_; }  ///< reads a saved result
    [[nodiscard]] JobSlot& writing() { return writing_; }
    [[nodiscard]] JobSlot& saving() { return saving_; }

Q_SIGNALS:
    void cityShown();        ///< city() has changed
    void projectOpened();    ///< another project, after cityShown()
    void answered();         ///< an answer has arrived or was returned to: answer(), studies()
    void ran();              ///< after answered(): the user asked for that run
    void measuredUpdated();  ///< isOutdated() of results
    void answerUpdated();    ///< answer() has other names, or agrees otherwise with the changed project
    void studyPartial(std::shared_ptr<const noonmark::PartialField> field);  ///< of the running study
    /// The requested run would take long and waits for runAnyway() or runQuicker(). The estimate covers all
    /// its fields.
    void longRun(noonmark::RunEstimate estimate);
    void studyStopped(bool cancelled);   ///< without an answer; the previous one stays
    void failed(noonmark::Error error);  ///< not emitted for cancelled work
    /// One of several that were to be measured; the others are there.
    void scenarioFailed(std::string scenario, noonmark::Error error);
    void openFailed(noonmark::Error error);          ///< or cancelled: the current project stays
    void recovered(std::filesystem::path recovery);  ///< recover() has finished
    void noted(QString text);
    void exported(QString folder);
    void commandFound(QString command);

private:
    using SharedAnswer = std::shared_ptr<const Answer>;
    void adoptProject(Result<OpenProject> opened, int version);
    void adoptRecovered(Result<ProjectFile> saved);
    [[nodiscard]] StudySettings firstQuestion() const;
    void follow();
    void adoptCity(Result<OpenCity> city);
    [[nodiscard]] bool isRunStillValid();
    void forgetAnswers();
    void updateAnswers();
    void replace(const SharedAnswer& before, const SharedAnswer& now);
    void bringToFront(SharedAnswer answer);
    [[nodiscard]] std::string freeMeasuredName(const std::string& name) const;
    void remember(const KnownAnswer& known, bool isWork);
    [[nodiscard]] std::string savedNameOf(const std::shared_ptr<const MeasuredAnswer>& measured) const;
    void showResult(const std::shared_ptr<const SavedResult>& result);
    void findOutdated();
    [[nodiscard]] bool isCurrent(const std::string& scenario, const std::shared_ptr<const City>& city);
    [[nodiscard]] std::string scenarioOf(const std::shared_ptr<const City>& city);
    void showByItself(const KnownAnswer& known);
    void showPast(SharedAnswer answer);
    void findBase();
    [[nodiscard]] bool isCompared();
    /// Of the displayed scenario and, if it compares, of its baseline.
    [[nodiscard]] bool isOfShown(const KnownAnswer& known);
    bool rename(SharedAnswer& answer);
    [[nodiscard]] const Question& questionOfRun() const;
    using Start = std::function<void()>;
    void startUnlessLong(double fields, Start start);
    void startPoints(Start start);
    void announceIfLong(const Result<RunEstimate>& one, double fields, const Start& start);
    [[nodiscard]] Result<Asked> makeAsked(const Question& question, const std::string& weights);
    [[nodiscard]] std::vector<std::string> listOtherScenarios() const;
    [[nodiscard]] std::vector<NamedCity> listOthers();
    void askNow(const Question& question, const std::string& weights);
    void compute(const Question& question, Asked asked);
    void adoptAnswer(KnownAnswer known, Result<SharedAnswer> answer);
    void measure(const QString& what, std::vector<KnownAnswer> wanted);
    /// The outcome of measuring one city.
    struct Measured {
        KnownAnswer study;
        std::optional<Error> error;  ///< of several: the others are measured all the same
    };
    void adoptStudies(Result<std::vector<Measured>> made);
    void reportAll(const std::vector<Measured>& made);
    void adoptStudy(const KnownAnswer& study);
    std::vector<KnownAnswer> listUnmeasured();
    using Files = Result<std::vector<std::filesystem::path>>;
    using Write =
        std::function<Files(const std::filesystem::path& folder, Progress&, const std::stop_token&)>;
    [[nodiscard]] AnswerFiles filesToWrite(const ExportChoice& choice) const;
    [[nodiscard]] Write whatToWrite(const ExportChoice& choice) const;
    [[nodiscard]] Write tableToWrite() const;
    [[nodiscard]] Write placeToWrite() const;
    [[nodiscard]] ScenarioStudies scenariosToShow();
    [[nodiscard]] Write scenariosToWrite(const ExportChoice& choice);
    [[nodiscard]] AnswerFiles withProject(AnswerFiles files) const;
    void report(const Error& error);

    Questions questions_ = allQuestions();
    StudyDocument document_;
    ProjectSession session_{document_.undoStack()};
    Source source_;
    ViewState openedView_;
    ZoneGuess zone_;
    Warnings placeWarnings_;
    std::shared_ptr<const OpenCity> city_;
    std::vector<KnownAnswer> studies_;
    KnownAnswer comparison_;  ///< the latest
    MeasuredAnswers measured_;
    std::map<std::shared_ptr<const MeasuredAnswer>, std::string> named_;  ///< saved under these names
    std::set<std::string> outdated_;
    /// The inputs for which outdated_ was computed.
    struct Compared {
        std::shared_ptr<const City> city;
        std::vector<Scenario> scenarios;
        std::vector<Place> places;
        std::vector<Region> regions;
        std::vector<std::shared_ptr<const SavedResult>> results;
        bool operator==(const Compared&) const = default;
    };
    Compared compared_;
    bool again_ = false;                                  ///< the latest question is that of runAgain()
    std::vector<std::shared_ptr<const City>> runningOn_;  ///< of the running question; none: an estimate
    std::shared_ptr<const Study> study_;
    SharedAnswer base_, front_, past_;
    using CitiesShown = std::pair<std::shared_ptr<const City>, std::shared_ptr<const City>>;
    CitiesShown shownOf_;                ///< displayed city and baseline when base_ and front_ were found
    std::optional<CitiesShown> pastOf_;  ///< those of past_, if it was in front
    [[nodiscard]] CitiesShown citiesShown();
    std::map<SharedAnswer, SharedAnswer> listed_;  ///< base_ and front_ as lists have them, if renamed since
    ListAnswers scenarioAnswers_;
    TableText scenarioTable_;
    FindPlace placeShown_;
    Start long_;  ///< the run announced by longRun()
    double answerSeconds_ = 0;
    JobSlot opening_;
    JobSlot following_;
    JobSlot running_;
    JobSlot reading_;
    JobSlot checking_;
    JobSlot writing_;
    JobSlot saving_;
};

}  // namespace noonmark
