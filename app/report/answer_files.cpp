#include "app/report/answer_files.h"

#include <QGuiApplication>

#include "app/report/impact_report.h"
#include "app/report/output_folder.h"
#include "app/report/score_report.h"
#include "core/io/write_raster.h"
#include "scenarios/impact/impact_runs.h"

namespace noonmark {

namespace {

using Path = std::filesystem::path;
using Paths = Result<std::vector<Path>>;

std::vector<RasterBand> bandsOf(const Impact& impact) {
    std::vector<RasterBand> bands{{"change of gross shadow", "min/day", &impact.grossMin}};
    if (hasRuns(impact)) bands.push_back({"change of continuous shadow", "min", &impact.continuousMin});
    return bands;
}

/// What both have: map, picture, page, figures and table under one name.
struct AnswerTexts {
    std::string name;
    std::string json;
    std::string csv;
};

Paths writeFiles(const AnswerTexts& texts, const Sheet& sheet, const Grid& grid, const Frame& frame,
                 const std::vector<RasterBand>& bands, const Path& folder) {
    if (qGuiApp == nullptr) return failure("Pictures and reports need a QGuiApplication", folder.string());
    OutputFolder files(folder);
    files.add(texts.name + ".tif", [&](const Path& file) { return writeGeoTiff(file, frame, grid, bands); });
    files.add(texts.name + ".png", [&](QIODevice& device) { return pictureOf(sheet).save(&device, "PNG"); });
    files.add(texts.name + ".pdf", [&](QIODevice& device) { return writePdf(sheet, device); });
    files.add(texts.name + ".json", textContent(texts.json));
    files.add(texts.name + ".csv", textContent(texts.csv));
    return std::move(files).result();
}

}  // namespace

Paths writeImpactFiles(const ImpactAnswer& answer, const AnswerSource& source, const ChangeScale& scale,
                       const Path& folder) {
    const Impact& impact = answer.study.total;
    return writeFiles({"impact", impactJson(answer), impactCsv(answer)}, sheetOf(answer, source, scale),
                      impact.grid, source.city.frame, bandsOf(impact), folder);
}

Paths writeScoreFiles(const ScoreAnswer& answer, const AnswerSource& source, const Path& folder) {
    const Score& score = answer.score;
    return writeFiles({"score", scoreJson(answer), scoreCsv(answer)}, sheetOf(answer, source), score.grid,
                      source.city.frame, {{"shadow score", "", &score.score}}, folder);
}

}  // namespace noonmark
