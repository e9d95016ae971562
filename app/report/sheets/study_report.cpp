#include "app/report/sheets/study_report.h"

#include "app/report/sheets/report_sections.h"
#include "core/measures/has_runs.h"

namespace noonmark {

namespace {

SheetMap mapOf(const Study& study, ShadowMeasure measure) {
    return {makeMapScene(study, measure), makeLegend(study.field, measure)};
}

std::vector<TextBlocks> sectionsOf(const Study& study) {
    std::vector<TextBlocks> sections = methodSections(study);
    for (TextBlocks& section : sourceSections(study)) sections.push_back(std::move(section));
    return sections;
}

}  // namespace

Sheet makeSheet(const Study& study) {
    Sheet sheet{.headline = makeHeadline(study, QStringLiteral("Shadow study")),
                .map = mapOf(study, ShadowMeasure::gross),
                .definitions = definitionBlocks(study),
                .figures = computeFigures(study),
                .sections = sectionsOf(study),
                .repeat = repeatBlocks(study),
                .credit = describeData(study),
                .record = {QStringLiteral("study.json"), studyJson(study)}};
    if (!isInstant(study.field) && hasRuns(study.statistics))
        sheet.smallMap.emplace(mapOf(study, ShadowMeasure::continuous));
    return sheet;
}

bool writeReport(const Study& study, QIODevice& device) { return writePdf(makeSheet(study), device); }

QImage mapPicture(const Study& study, ShadowMeasure measure, int width) {
    const QString subject = isInstant(study.field) ? QStringLiteral("Shadow") : nameOf(measure);
    return makePicture(Sheet{.headline = makeHeadline(study, subject),
                             .map = mapOf(study, measure),
                             .credit = describeData(study)},
                       width);
}

}  // namespace noonmark
