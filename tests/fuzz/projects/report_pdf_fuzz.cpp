// A filed report: a PDF with its record attached, and the words on its pages.
#include "app/report/files/read_report.h"
#include "core/study/verification/result_record.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark;
    using namespace noonmark::tests;
    const auto file = fuzzFile("report.pdf", formatText(data, size));
    if (const auto pages = comparePages(file, file, {}); !pages) requireSound(pages.error());
    const auto report = readReport(file, {"study.json"});
    if (!report) return requireSound(report.error()), 0;
    if (const auto record = parseResultRecord(report->record, {"study"}, report->recordName); !record)
        requireSound(record.error());
    return 0;
}
