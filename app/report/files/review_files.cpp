#include "app/report/files/review_files.h"

#include "app/report/files/output_folder.h"
#include "app/report/files/shadow_files.h"
#include "core/study/text/warnings_json.h"

namespace noonmark {

std::vector<std::string> reviewFileNames() {
    return {"review.json", "review.csv", "shadows.dxf", "shadows.gpkg"};
}

Result<std::vector<std::filesystem::path>> writeReviewFiles(const ReviewStudy& study,
                                                            const ReviewLabels& labels,
                                                            const ShadowDrawing& shadows,
                                                            const std::filesystem::path& folder,
                                                            const OutputRules& rules) {
    if (auto may = checkOutputs(folder, reviewFileNames(), rules); !may)
        return tl::make_unexpected(may.error());
    OutputFolder files(folder, rules);
    files.add("review.json", textContent(toJsonText(reviewJson(study, labels)) + "\n"));
    files.add("review.csv", textContent(reviewCsv(study, labels)));
    addShadowFiles(files, shadows, {});
    return std::move(files).result();
}

}  // namespace noonmark
