#include <algorithm>

#include "app/gui/base/files/file_dialogs.h"
#include "app/gui/session/answers/answer_viewer.h"
#include "app/gui/session/workbench.h"
#include "app/input/load_city.h"
#include "app/questions/review_question.h"
#include "app/questions/saved_question.h"
#include "app/report/files/answer_files.h"
#include "app/report/files/output_folder.h"
#include "app/report/scenarios/scenario_book.h"
#include "app/report/scenarios/scenario_study.h"
#include "core/study/provenance/command_text.h"
#include "scenarios/project/results/save_result.h"
#include "scenarios/scenario.h"

// What Workbench saves in the project and writes as files.
namespace noonmark {

namespace {

using WrittenPaths = std::vector<std::filesystem::path>;
constexpr std::size_t commandLetters = 120;
constexpr const char* viewFileName = "view.png";
constexpr const char* tableFileName = "scenario_table.csv";

// With what each was made from.
ScenarioStudies stateOrigin(ScenarioStudies scenarios, const AnswerOrigin& origin) {
    for (ScenarioStudy& one : scenarios) {
        const auto& score = one.answers.score;
        one.study = origin.stated(*one.study, one.name, score ? score->weights : std::string());
    }
    return scenarios;
}

}  // namespace

AnswerFiles Workbench::withProject(AnswerFiles files) const {
    const SheetSettings& sheets = session_.project().sheets;
    files.book.titleBlock = sheets.titleBlock;
    files.book.units = sheets.units;
    files.regions = session_.project().regions;
    files.rules = exportRules();
    return files;
}

namespace {

// The books that an export may write: at most one of them.
constexpr const char* bookFileNames[] = {sheetsFileName, "scenarios.pdf", "elements.pdf"};

std::vector<std::pair<std::string, std::string>> renamedFiles(const ExportChoice& choice) {
    std::vector<std::pair<std::string, std::string>> renamed;
    for (const char* name : bookFileNames)
        if (!choice.sheetsName.empty()) renamed.emplace_back(name, choice.sheetsName);
    return renamed;
}

}  // namespace

AnswerFiles Workbench::filesToWrite(const ExportChoice& choice) const {
    AnswerFiles files = withProject(choice);
    files.rules.renamed = renamedFiles(choice);
    return files;
}

bool Workbench::hasSheets(const ExportChoice& choice) {
    ExportChoice standard = choice;
    standard.sheetsName.clear();
    const QStringList names = filesOf(standard);
    return std::ranges::any_of(bookFileNames,
                               [&](const char* name) { return names.contains(QString::fromLatin1(name)); });
}

// Captures the displayed answer, since another may be displayed by the time of writing.
Workbench::Write Workbench::whatToWrite(const ExportChoice& choice) const {
    return [answer = answer(), origin = AnswerOrigin(session_), city = session_.city(),
            how = filesToWrite(choice)](const auto& folder, Progress& progress, const std::stop_token& stop) {
        AnswerFiles watched = how;
        watched.progress = &progress;
        watched.stop = stop;
        return origin.stated(answer)->write(*city, folder, watched);
    };
}

std::vector<std::string> Workbench::measuredScenarios() {
    const auto known = studies();
    std::vector<std::string> names;
    for (const std::string& name : listNames(session_.project().scenarios)) {
        const auto study = known.find(name);
        if (study != known.end() && study->second->settings == document_.settings()) names.push_back(name);
    }
    return names;
}

ScenarioStudies Workbench::scenariosToShow() {
    const auto known = studies();
    auto answers = scenarioAnswers_ ? scenarioAnswers_() : std::map<std::string, ScenarioAnswers>();
    ScenarioStudies measured;
    for (const std::string& name : measuredScenarios()) {
        measured.push_back(makeScenarioStudy(session_.project().scenarios, name, known.at(name)));
        measured.back().answers = std::move(answers[name]);
    }
    return measured;
}

Workbench::Write Workbench::scenariosToWrite(const ExportChoice& choice) {
    return [measured = scenariosToShow(), origin = AnswerOrigin(session_), how = filesToWrite(choice)](
               const auto& folder, auto&&...) {
        return writeScenarioFiles(stateOrigin(measured, origin), bookOf(how), folder, how.rules);
    };
}

Workbench::Write Workbench::placeToWrite() const {
    return [study = study_, place = placeShown(), origin = AnswerOrigin(session_),
            scenario = session_.scenario(), rules = exportRules()](const auto& folder, auto&&...) {
        return writeContributionFiles(*origin.stated(*study, scenario), *place, folder, rules);
    };
}

bool Workbench::hasScenarioAnswers() const {
    if (!scenarioAnswers_ || !scenarioTable_) return false;
    return std::ranges::any_of(scenarioAnswers_(), [](const auto& one) {
        const ScenarioAnswers& answers = one.second;
        return answers.score || answers.verdicts || answers.impact || answers.sun;
    });
}

// The text is that of the table now, whatever changes until it is written.
Workbench::Write Workbench::tableToWrite() const {
    return [text = scenarioTable_(), rules = exportRules()](const auto& folder, auto&&...) {
        OutputFolder files(folder, rules);
        files.add(tableFileName, textContent(text));
        return std::move(files).result();
    };
}

OutputRules Workbench::exportRules() const {
    std::vector<std::string> named;
    if (session_.file()) named.push_back(session_.file()->path().string());
    return outputRules(named, session_.project().inputs, true);
}

QStringList Workbench::filesOf(const ExportChoice& choice) {
    std::vector<std::string> names;
    if (choice.subject == ExportChoice::Subject::scenarios)
        names = scenarioFileNames();
    else if (const auto place = placeShown(); place && choice.subject == ExportChoice::Subject::place)
        names = contributionFileNames(*place);
    else if (choice.subject == ExportChoice::Subject::table)
        names = {tableFileName};
    else if (choice.subject == ExportChoice::Subject::view)
        names = {viewFileName};
    else if (choice.subject == ExportChoice::Subject::shown && answer())
        names = answer()->fileNames(choice);
    OutputRules rules;
    rules.renamed = renamedFiles(choice);
    QStringList list;
    for (const std::string& name : names) list << QString::fromStdString(nameOf(name, rules));
    return list;
}

SheetsToMake Workbench::sheetsOf(const ExportChoice& choice) {
    using Sheets = Result<std::shared_ptr<const Book>>;
    const AnswerFiles how = withProject(choice);
    SheetsToMake sheets{
        {{}, {}, AnswerOrigin(session_), how.scale, how.thresholdHours, bookOf(how), how.regions}, {}};
    if (choice.subject == ExportChoice::Subject::scenarios) {
        ScenarioStudies measured = scenariosToShow();
        sheets.from.scenarios = scenariosCsv(measured);
        sheets.make = [measured = std::move(measured), origin = AnswerOrigin(session_), book = bookOf(how)](
                          Progress&, const std::stop_token&) -> Sheets {
            const auto stated = std::make_shared<const ScenarioStudies>(stateOrigin(measured, origin));
            return bundleBook(makeScenarioBook(*stated, book), stated);
        };
        return sheets;
    }
    ExportChoice other = choice;
    other.sheets = !other.sheets;
    const bool areFiled = choice.sheets || filesOf(choice) == filesOf(other);
    if (choice.subject != ExportChoice::Subject::shown || !answer() || !areFiled) return {};
    sheets.from.answer = answer();
    sheets.make = [answer = answer(), city = session_.city(), origin = AnswerOrigin(session_), how](
                      Progress& progress, const std::stop_token& stop) -> Sheets {
        AnswerFiles watched = how;
        watched.progress = &progress;
        watched.stop = stop;
        return origin.stated(answer)->layOut(city, watched);
    };
    return sheets;
}

QStringList Workbench::listExistingFiles(const std::filesystem::path& folder, const ExportChoice& choice) {
    std::vector<std::string> names;
    for (const QString& name : filesOf(choice)) names.push_back(name.toStdString());
    return noonmark::listExistingFiles(QString::fromStdString(folder.string()), names);
}

void Workbench::exportShown(const std::filesystem::path& folder, const ExportChoice& choice) {
    using Subject = ExportChoice::Subject;
    const bool scenarios = choice.subject == Subject::scenarios;
    const bool place = choice.subject == Subject::place && study_ && placeShown();
    const bool table = choice.subject == Subject::table && hasScenarioAnswers();
    if (!scenarios && !place && !table && !answer())
        return report({QT_TRANSLATE_NOOP("Error", "There is no result to export"),
                       {},
                       QT_TRANSLATE_NOOP("Error", "Press Run first")});
    writing_.start<WrittenPaths>(
        tr("Exporting"),
        [write = scenarios ? scenariosToWrite(choice)
                 : place   ? placeToWrite()
                 : table   ? tableToWrite()
                           : whatToWrite(choice),
         project = choice.withProject ? session_.file() : std::nullopt,
         folder](Progress& progress, const std::stop_token& stop) -> Result<WrittenPaths> {
            if (!project) return write(folder, progress, stop);
            if (const auto may = checkCopy(*project, folder); !may) return tl::make_unexpected(may.error());
            auto paths = write(folder, progress, stop);
            if (!paths) return paths;
            return copyProject(*project, folder).map([&] { return *std::move(paths); });
        },
        [this, folder](Result<WrittenPaths> paths) {
            if (!paths) return report(paths.error());
            QStringList names;
            for (const auto& path : *paths) names << QString::fromStdString(path.filename().string());
            Q_EMIT noted(
                tr("Exported to %1: %2").arg(QString::fromStdString(folder.string()), names.join(tr(", "))));
            Q_EMIT exported(QString::fromStdString(folder.string()));
        });
}

void Workbench::findCommand(const AnswerFiles& drawn) {
    if (!answer())
        return report({QT_TRANSLATE_NOOP("Error", "There is no result"),
                       {},
                       QT_TRANSLATE_NOOP("Error", "Press Run first")});
    writing_.start<std::string>(
        tr("Finding the command"),
        [answer = answer(), drawn, origin = AnswerOrigin(session_)](Progress&, const std::stop_token&) {
            return origin.stated(answer)->command().map([&](const std::string& command) {
                return extendCommand(command, answer->drawnOptions(drawn), commandLetters);
            });
        },
        [this](const Result<std::string>& command) {
            if (!command) return report(command.error());
            Q_EMIT commandFound(QString::fromStdString(*command));
        });
}

void Workbench::saveAnswer(const QString& name) {
    if (const std::string saved = savedName(); !saved.empty())
        return report({QT_TRANSLATE_NOOP("Error", "This result is already saved"), saved, {}});
    if (saving_.busy())
        return report({QT_TRANSLATE_NOOP("Error", "Another result is being saved"),
                       {},
                       QT_TRANSLATE_NOOP("Error", "Wait until it is saved")});
    if (!answer())
        return report({QT_TRANSLATE_NOOP("Error", "There is no result to save"),
                       {},
                       QT_TRANSLATE_NOOP("Error", "Press Run first")});
    saving_.start<SavedResult>(
        tr("Saving %1").arg(name),
        [answer = answer(), origin = AnswerOrigin(session_), project = session_.project()](
            Progress&, const std::stop_token&) -> Result<SavedResult> {
            return origin.stated(answer)->toSave(project);
        },
        [this, name, measured = measuredShown()](Result<SavedResult> result) {
            if (!result) return report(result.error());
            result->name = freeName(session_.project(), ProjectPart::result, name.toStdString());
            if (measured) named_[measured] = result->name;
            const QString saved = shownName(*result);
            session_.change(addResult(session_.project(), *std::move(result)),
                            tr("save result %1").arg(saved));
            Q_EMIT noted(
                tr("%1 is saved with the project: the list above the results shows it again").arg(saved));
        });
}

}  // namespace noonmark
