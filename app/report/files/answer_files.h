#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/report/book/book.h"
#include "app/report/maps/change_scale.h"
#include "app/report/sheets/answer_reports.h"
#include "app/report/sheets/sheet.h"
#include "core/io/files/check_output.h"
#include "core/study/contributions/place_contributions.h"
#include "scenarios/impact/impact_text.h"
#include "scenarios/weights/score_text.h"

namespace noonmark {

/// Writes the files of a comparison into a folder, which is created if missing: impact.tif with
/// its style impact.qml, impact.png,
/// impact.pdf, impact.json, impact.csv, and region.geojson where the repeat command names it. The window and
/// the command line write the same files. `rules`: which files may be replaced.
/// `sheets`: also write sheets.pdf, a book so laid out. `width` of the picture in pixels: see makePicture().
/// Returns the paths written; a file is written completely or not at all. Needs a QGuiApplication (the
/// `offscreen` platform suffices).
Result<std::vector<std::filesystem::path>> writeImpactFiles(
    const ImpactAnswer& answer, const AnswerSource& source, const ChangeScale& scale,
    const std::filesystem::path& folder, const OutputRules& rules = {}, const BookSettings* sheets = nullptr,
    int width = pictureWidth, const LegendChoice& legend = {});

/// The same for a score: score.tif, score.qml, score.png, score.pdf, score.json, score.csv.
Result<std::vector<std::filesystem::path>> writeScoreFiles(
    const ScoreAnswer& answer, const AnswerSource& source, const std::filesystem::path& folder,
    const OutputRules& rules = {}, const BookSettings* sheets = nullptr, int width = pictureWidth,
    const LegendChoice& legend = {});

/// The names of those files, known before the computation; `provenance` states the region.
std::vector<std::string> impactFileNames(const Provenance& provenance, bool withSheets = false);
std::vector<std::string> scoreFileNames(const Provenance& provenance, bool withSheets = false);

/// contributions.csv and contributions.gpkg of a place, as those of a study, and by_month.csv.
std::vector<std::string> contributionFileNames();

/// Writes them, all or none, as what `study` holds of the place. Returns the paths written.
Result<std::vector<std::filesystem::path>> writeContributionFiles(const Study& study,
                                                                  const PlaceContributions& of,
                                                                  const std::filesystem::path& folder,
                                                                  const OutputRules& rules);

}  // namespace noonmark
