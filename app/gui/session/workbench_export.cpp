#include <algorithm>

#include "app/gui/session/answers/answer_origin.h"
#include "app/gui/session/workbench.h"
#include "app/input/output_rules.h"
#include "app/report/files/answer_files.h"
#include "app/report/files/element_files.h"
#include "app/report/files/saved_files.h"
#include "app/report/files/study_files.h"
#include "app/report/scenarios/scenario_files.h"
#include "core/study/text/region_text.h"
#include "scenarios/scenario_list.h"

// The files that Workbench writes.
namespace noonmark {

namespace {

using WrittenPaths = std::vector<std::filesystem::path>;

StudyFileOptions studyOptions(const ExportChoice& choice, const OutputRules& rules) {
    return {.cellsCsv = choice.cells, .rules = rules, .pictureWidth = choice.pictureWidth};
}

std::vector<std::string> allChanges(const ShownResult& saved) {
    std::vector<std::string> all = saved.changes;
    all.insert(all.end(), saved.weightChanges.begin(), saved.weightChanges.end());
    return all;
}

}  // namespace

BookSettings Workbench::bookSettings(const ExportChoice& choice) const {
    const SheetSettings& sheets = session_.project().sheets;
    return {choice.setup, std::nullopt, sheets.titleBlock, sheets.units};
}

// Captures the result displayed now, since another may be displayed by the time of writing.
Workbench::Write Workbench::whatToWrite(const ExportChoice& choice) const {
    const AnswerOrigin origin(session_);
    const OutputRules rules = exportRules();
    const BookSettings book = bookSettings(choice);
    if (saved_)
        return
            [result = *findResult(session_.project(), saved_->name), saved = saved_, city = session_.city(),
             regions = session_.project().regions, rules, choice](const auto& folder) {
                return writeSavedFiles(*result, {*city, allChanges(*saved), regions}, choice.scale, folder,
                                       rules, choice.pictureWidth);
            };
    if (score_)
        return [score = score_, origin, city = session_.city(), rules, book, choice](const auto& folder) {
            return writeScoreFiles(origin.stated(*score), {*city}, folder, rules,
                                   choice.sheets ? &book : nullptr, choice.pictureWidth);
        };
    if (elements_)
        return [elements = elements_, origin, rules, book](const auto& folder) {
            return writeElementFiles(origin.stated(elements->study), book, folder, rules);
        };
    if (comparison_)
        return [comparison = comparison_, origin, city = session_.city(), rules, book,
                choice](const auto& folder) {
            return writeImpactFiles(origin.stated(*comparison), {*city}, choice.scale, folder, rules,
                                    choice.sheets ? &book : nullptr, choice.pictureWidth);
        };
    return [study = study_, origin, options = studyOptions(choice, rules)](const auto& folder) {
        return writeStudyFiles(origin.stated(*study), folder, options);
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

Workbench::Write Workbench::scenariosToWrite(const ExportChoice& choice) {
    const auto known = studies();
    auto answers = scenarioAnswers_ ? scenarioAnswers_() : std::map<std::string, ScenarioAnswers>();
    ScenarioStudies measured;
    for (const std::string& name : measuredScenarios()) {
        const auto edits = collectEdits(session_.project().scenarios, name).value_or(std::vector<Edit>());
        measured.push_back({name, known.at(name), sumUses(edits),
                            findProposedHeightM(known.at(name)->city, edits), std::move(answers[name])});
    }
    return [measured, origin = AnswerOrigin(session_), rules = exportRules(),
            book = bookSettings(choice)](const auto& folder) {
        ScenarioStudies stated = measured;
        for (ScenarioStudy& one : stated)
            one.study = std::make_shared<const Study>(origin.stated(*one.study, one.name));
        return writeScenarioFiles(stated, book, folder, rules);
    };
}

OutputRules Workbench::exportRules() const {
    std::vector<std::string> named;
    if (session_.file()) named.push_back(session_.file()->path().string());
    return outputRules(named, session_.project().inputs, true);
}

QStringList Workbench::filesOf(const ExportChoice& choice) {
    Provenance anyRegion;
    anyRegion.region = regionFileName;
    std::vector<std::string> names;
    if (choice.subject == ExportChoice::Subject::scenarios)
        names = scenarioFileNames();
    else if (choice.subject == ExportChoice::Subject::shown) {
        if (shown() == Shown::savedResult)
            if (const auto result = findResult(session_.project(), saved_->name))
                names = savedFileNames(**result);
        if (shown() == Shown::score) names = scoreFileNames(anyRegion, choice.sheets);
        if (shown() == Shown::comparison) names = impactFileNames(anyRegion, choice.sheets);
        if (shown() == Shown::elements) {
            names = elementFileNames(elements_->study.elements.places);
            names.emplace_back(regionFileName);
        }
        if (shown() == Shown::study) {
            names = studyFileNames(study_->settings, studyOptions(choice, {}));
            names.emplace_back(regionFileName);
        }
    }
    QStringList list;
    for (const std::string& name : names) list << QString::fromStdString(name);
    return list;
}

QStringList Workbench::filesInTheWay(const std::filesystem::path& folder, const ExportChoice& choice) {
    std::vector<std::string> names;
    for (const QString& name : filesOf(choice)) names.push_back(name.toStdString());
    QStringList there;
    for (const std::string& name : findExistingOutputs(folder, names)) there << QString::fromStdString(name);
    return there;
}

void Workbench::exportShown(const std::filesystem::path& folder, const ExportChoice& choice) {
    const bool scenarios = choice.subject == ExportChoice::Subject::scenarios;
    if (!scenarios && shown() == Shown::nothing)
        return tell({"There is no result to export", {}, "Press Run first"});
    writing_.start<WrittenPaths>(
        tr("Exporting"),
        [write = scenarios ? scenariosToWrite(choice) : whatToWrite(choice), folder](
            Progress&, std::stop_token) { return write(folder); },
        [this, folder](Result<WrittenPaths> paths) {
            if (!paths) return tell(paths.error());
            QStringList names;
            for (const auto& path : *paths) names << QString::fromStdString(path.filename().string());
            Q_EMIT noted(
                tr("Exported to %1: %2").arg(QString::fromStdString(folder.string()), names.join(tr(", "))));
        });
}

}  // namespace noonmark
