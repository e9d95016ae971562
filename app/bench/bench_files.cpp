#include "app/bench/bench_files.h"

#include "app/bench/bench_pages.h"
#include "app/report/output_folder.h"

namespace noonmark {

Result<std::vector<std::filesystem::path>> writeBenchFiles(const bench::BenchReport& report,
                                                           const std::filesystem::path& folder) {
    OutputFolder files(folder);
    for (const bench::Finding& finding : report.findings)
        if (!finding.key.empty()) files.add(finding.key + ".csv", textContent(csvOf(finding.table)));
    files.add("report.pdf", [&](QIODevice& device) { return writeBenchPages(report, device); });
    files.add("summary.json", textContent(summaryJson(report)));
    return std::move(files).result();
}

}  // namespace noonmark
