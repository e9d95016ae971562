#include "app/report/files/contribution_files.h"

#include "app/report/files/output_folder.h"
#include "core/study/text/breakdown_text.h"

namespace noonmark {

std::vector<std::string> contributionFileNames() {
    return {"contributions.csv", "contributions.gpkg", "by_month.csv"};
}

Result<std::vector<std::filesystem::path>> writeContributionFiles(const Study& study,
                                                                  const PlaceContributions& of,
                                                                  const std::filesystem::path& folder,
                                                                  const OutputRules& rules) {
    if (auto may = checkOutputs(folder, contributionFileNames(), rules); !may)
        return tl::make_unexpected(may.error());
    OutputFolder files(folder, rules);
    files.add("contributions.csv",
              textContent(contributionsCsv(of.rows, of.breakdown.sets, study.provenance)));
    files.add("contributions.gpkg", [&](const std::filesystem::path& file) {
        return writeCityGeoPackage(file, study.city,
                                   contributionColumns(of.rows, study.city.buildings.size()),
                                   contributionStyle())
            .map([](const Warnings&) {});
    });
    files.add("by_month.csv", textContent(monthsCsv(monthsOf(of.breakdown), study.provenance)));
    return std::move(files).result();
}

}  // namespace noonmark
