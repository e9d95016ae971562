#include "app/report/sheets/study_report.h"

#include "app/report/sheets/report_sections.h"
#include "core/measures/has_runs.h"
#include "core/measures/shadow_figures.h"
#include "core/study/provenance/command_words.h"
#include "core/study/text/region_text.h"

namespace noonmark {

namespace {

SheetMap mapOf(const Study& study, ShadowMeasure measure, const LegendChoice& legend) {
    return {makeMapScene(study, measure, legend), makeLegend(study.field, measure, legend)};
}

std::vector<TextBlocks> sectionsOf(const Study& study) {
    std::vector<TextBlocks> sections = methodSections(study);
    for (TextBlocks& section : sourceSections(study)) sections.push_back(std::move(section));
    return sections;
}

}  // namespace

Sheet makeSheet(const Study& study, const LegendChoice& legend) {
    Sheet sheet{.headline = makeHeadline(study, QStringLiteral("Shadow study")),
                .map = mapOf(study, ShadowMeasure::gross, legend),
                .definitions = definitionBlocks(study, legend.show),
                .figures = computeFigures(study, legend.show),
                .sections = sectionsOf(study),
                .repeat = repeatBlocks(study, listLegendOptions(legend, false)),
                .credit = describeData(study),
                .record = {QStringLiteral("study.json"),
                           extendRepeat(studyJson(study), listLegendOptions(legend, false))}};
    const AnswerPage page =
        makePage(study.field, study.statistics, nameOf(study.settings.region), legend.show);
    if (!page.headline.source.empty())
        sheet.finding = QString::fromStdString(formatText(page.headline)) + u'.';
    if (!isInstant(study.field) && hasRuns(study.statistics))
        sheet.smallMap.emplace(mapOf(study, ShadowMeasure::continuous, legend));
    return sheet;
}

bool writeReport(const Study& study, QIODevice& device, const LegendChoice& legend) {
    return writePdf(makeSheet(study, legend), device);
}

QImage mapPicture(const Study& study, ShadowMeasure measure, int width, const LegendChoice& legend) {
    const SheetMap map = mapOf(study, measure, legend);
    const QString subject = isInstant(study.field) ? QStringLiteral("Shadow") : map.legend.title;
    return makePicture(
        Sheet{.headline = makeHeadline(study, subject), .map = map, .credit = describeData(study)}, width);
}

}  // namespace noonmark
