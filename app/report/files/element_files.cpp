#include "app/report/files/element_files.h"

#include "app/report/book/answer_books.h"
#include "app/report/book/print_book.h"
#include "app/report/files/output_folder.h"
#include "app/report/maps/answer_legends.h"
#include "core/study/elements/element_models.h"
#include "core/study/elements/element_tables.h"
#include "core/study/text/error_text.h"
#include "core/study/text/region_text.h"

namespace noonmark {

namespace {

constexpr const char* cityJsonName = "elements.city.json";

bool hasElevations(ElementPlaces places) {
    return places == ElementPlaces::facades || places == ElementPlaces::windows;
}

bool needsRegionFile(const ElementStudy& study) {
    const std::string& known = study.provenance.region;
    return (known.empty() ? formatRegion(study.settings.region, study.city) : known) == regionFileName;
}

// `shown`: the column that the legend names, if the map has it.
LayerStyle styleShown(const ElementMap& map, const std::optional<ElementMap>& shown,
                      const LegendChoice& legend) {
    return makeStyle(coloursOf(makeLegend(shown ? *shown : map, ShadowMeasure::gross, legend)),
                     shown ? suffixOf(legend.trees) : std::string());
}

}  // namespace

LayerStyle styleColumn(const ElementMap& map, const LegendChoice& legend) {
    return styleShown(map, inColumn(map, legend.trees), legend);
}

std::vector<std::string> elementFileNames(ElementPlaces places) {
    std::vector<std::string> names{"elements.csv", "elements.gpkg", "elements.glb", "study.json"};
    if (hasElevations(places)) names.emplace_back("elements.pdf");
    return names;
}

Result<std::vector<std::filesystem::path>> writeElementFiles(const ElementStudy& study,
                                                             const BookSettings& settings,
                                                             const std::filesystem::path& folder,
                                                             const OutputRules& rules) {
    std::vector<std::string> names = elementFileNames(study.elements.places);
    if (needsRegionFile(study)) names.emplace_back(regionFileName);
    const ElementMap map = makeElementMap(study);
    const auto cityJson = copyCityJsonOf(study, map);
    if (cityJson) names.emplace_back(cityJsonName);
    if (auto may = checkOutputs(folder, names, rules); !may) return tl::make_unexpected(may.error());
    const ElementTable table = makeElementTable(map, study.city, sourceValues(study.provenance));
    const auto shown = inColumn(map, settings.legend.trees);
    const LayerStyle style = styleShown(map, shown, settings.legend);
    QByteArray pdf;
    if (hasElevations(study.elements.places)) {
        auto printed = printBook(makeElementBook(study, shown ? *shown : map, settings));
        if (!printed) return tl::make_unexpected(printed.error());
        pdf = *std::move(printed);
    }
    OutputFolder files(folder, rules);
    files.add("elements.csv", textContent(toCsv(table)));
    files.add("elements.gpkg",
              [&](const std::filesystem::path& file) { return writeElementsGeoPackage(file, table, style); });
    files.add("elements.glb", textContent(toGlb(map)));
    if (!pdf.isEmpty()) files.add("elements.pdf", textContent(pdf.toStdString()));
    if (cityJson) files.add(cityJsonName, textContent(*cityJson));
    files.addLast("study.json", [&](const OutputFolder::Durations& seconds) {
        return extendRepeat(elementStudyJson(study, seconds), listLegendOptions(settings.legend, false));
    });
    if (needsRegionFile(study))
        files.add(regionFileName, textContent(regionGeoJson(study.settings.region, study.city.frame)));
    return std::move(files).result();
}

namespace {

// In the colours of the sheets.
LayerStyle styleVerdicts() {
    std::vector<ColourClass> classes;
    for (const Verdict verdict :
         {Verdict::pass, Verdict::borderline, Verdict::fail, Verdict::notApplicable, Verdict::notChecked}) {
        const QColor mark = verdictMark(verdict);
        const Rgb colour{std::uint8_t(mark.red()), std::uint8_t(mark.green()), std::uint8_t(mark.blue())};
        classes.push_back({.colour = colour, .label = std::string(nameOf(verdict))});
    }
    return {"Verdicts after", categorizedStyle(StyledShape::points, "verdict_after", classes)};
}

}  // namespace

std::vector<std::string> glazingFileNames() {
    return {"review.json", "windows.csv", "windows.gpkg", "sheets.pdf"};
}

Result<std::vector<std::filesystem::path>> writeGlazingFiles(
    const GlazingBookSource& source, const BookSettings& settings, const std::filesystem::path& folder,
    bool byteOrderMark, const OutputRules& rules, Progress& progress, const std::stop_token& stop) {
    if (auto may = checkOutputs(folder, glazingFileNames(), rules); !may)
        return tl::make_unexpected(may.error());
    const auto book = makeGlazingBook(source, settings, progress, stop);
    if (!book) return tl::make_unexpected(book.error());
    const auto pdf = printBook(*book);
    if (!pdf) return tl::make_unexpected(pdf.error());
    const ElementTable table = makeGlazingTable(source.study, source.labels);
    OutputFolder files(folder, rules);
    files.add("review.json", textContent(toJsonText(glazingReviewJson(source.study, source.labels)) + "\n"));
    files.add("windows.csv", textContent((byteOrderMark ? "\xEF\xBB\xBF" : "") + toCsv(table)));
    files.add("windows.gpkg", [&](const std::filesystem::path& file) {
        return writeElementsGeoPackage(file, table, styleVerdicts());
    });
    files.add("sheets.pdf", textContent(pdf->toStdString()));
    return std::move(files).result();
}

}  // namespace noonmark
