#include "app/report/files/review_files.h"

#include "app/report/book/print_book.h"
#include "app/report/files/output_folder.h"
#include "app/report/files/shadow_files.h"
#include "core/study/shadow_drawings.h"
#include "core/study/text/warnings_json.h"

namespace noonmark {

namespace {

constexpr const char* utf8Mark = "\xEF\xBB\xBF";

Result<ShadowDrawing> drawShadows(const ReviewBookSource& source, Progress& progress,
                                  const std::stop_token& stop) {
    return drawReviewShadows(source.study, source.baseline, source.scenario, source.places, progress, stop)
        .map([&](ShadowDrawing drawing) {
            drawing.notes.push_back("From " + source.labels.from + " to " + source.labels.to);
            return drawing;
        });
}

}  // namespace

std::vector<std::string> reviewFileNames() {
    return {"review.json", "review.csv", "sheets.pdf", "shadows.dxf", "shadows.gpkg"};
}

Result<std::vector<std::filesystem::path>> writeReviewFiles(const ReviewBookSource& source,
                                                            const Book& sheets,
                                                            const ReviewFileSettings& settings,
                                                            const std::filesystem::path& folder,
                                                            Progress& progress, const std::stop_token& stop) {
    if (auto may = checkOutputs(folder, reviewFileNames(), settings.rules); !may)
        return tl::make_unexpected(may.error());
    const auto drawing = drawShadows(source, progress, stop);
    if (!drawing) return tl::make_unexpected(drawing.error());
    const auto pdf = printBook(sheets);
    if (!pdf) return tl::make_unexpected(pdf.error());
    OutputFolder files(folder, settings.rules);
    files.add("review.json", textContent(toJsonText(reviewJson(source.study, source.labels)) + "\n"));
    files.add("review.csv",
              textContent((settings.byteOrderMark ? utf8Mark : "") + reviewCsv(source.study, source.labels)));
    files.add("sheets.pdf", textContent(pdf->toStdString()));
    addShadowFiles(files, *drawing, {});
    return std::move(files).result();
}

}  // namespace noonmark
