#include "app/bench/bench_files.h"

#include <QBuffer>

#include "app/bench/bench_pages.h"
#include "app/report/files/output_folder.h"

namespace noonmark {

Result<std::vector<std::filesystem::path>> writeBenchFiles(const bench::BenchReport& report,
                                                           const std::filesystem::path& folder,
                                                           const OutputRules& rules) {
    OutputFolder files(folder, rules);
    for (const bench::Finding& finding : report.findings)
        if (!finding.key.empty()) files.add(finding.key + ".csv", textContent(toCsv(finding.table)));
    QBuffer pages;  // charts are painted on this thread only
    pages.open(QIODevice::WriteOnly);
    const bool painted = writeBenchPages(report, pages);
    files.add("report.pdf",
              [&](QIODevice& device) { return painted && device.write(pages.data()) == pages.size(); });
    files.add("summary.json", textContent(summaryJson(report)));
    return std::move(files).result();
}

std::vector<std::string> benchFileNames(std::span<const char* const> keys) {
    std::vector<std::string> names{"report.pdf", "summary.json"};
    for (const char* key : keys) names.push_back(std::string(key) + ".csv");
    return names;
}

}  // namespace noonmark
