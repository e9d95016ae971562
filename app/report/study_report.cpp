#include "app/report/study_report.h"

#include "app/report/report_sections.h"
#include "core/measures/has_runs.h"

namespace noonmark {

namespace {

SheetMap mapOf(const Study& study, ShadowMeasure measure) {
    return {sceneOf(study, measure), legendOf(study.field, measure)};
}

std::vector<TextBlocks> sectionsOf(const Study& study) {
    std::vector<TextBlocks> sections = methodSections(study);
    for (TextBlocks& section : sourceSections(study)) sections.push_back(std::move(section));
    return sections;
}

}  // namespace

Sheet sheetOf(const Study& study) {
    Sheet sheet{.headline = headlineOf(study, QStringLiteral("Shadow study")),
                .map = mapOf(study, ShadowMeasure::gross),
                .definitions = definitionBlocks(study),
                .figures = figuresOf(study),
                .sections = sectionsOf(study),
                .repeat = repeatBlocks(study),
                .credit = dataWords(study)};
    if (!isInstant(study.field) && hasRuns(study.statistics))
        sheet.smallMap.emplace(mapOf(study, ShadowMeasure::continuous));
    return sheet;
}

bool writeReport(const Study& study, QIODevice& device) { return writePdf(sheetOf(study), device); }

QImage mapPicture(const Study& study, ShadowMeasure measure) {
    const QString subject = isInstant(study.field) ? QStringLiteral("Shadow") : nameOf(measure);
    return pictureOf(Sheet{
        .headline = headlineOf(study, subject), .map = mapOf(study, measure), .credit = dataWords(study)});
}

}  // namespace noonmark
