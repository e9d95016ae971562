#include "app/report/files/glazing_files.h"

#include "app/report/book/print_book.h"
#include "app/report/files/output_folder.h"
#include "app/report/maps/verdict_colour.h"
#include "core/study/elements/element_tables.h"
#include "core/study/text/warnings_json.h"

namespace noonmark {

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
