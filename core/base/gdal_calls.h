#pragma once

#include <cstddef>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/stop_scope.h"

namespace noonmark {

/// RAII guard around calls to GDAL. It makes sure that GDAL is set up for untrusted files (gdal_setup.h), and
/// it collects GDAL's messages on this thread instead of letting GDAL print them. It is a StopScope:
/// after a stop request every file that GDAL reads on this thread is at its end (gdal_files.h), since no
/// driver can be stopped in another way. Backend: gdal_calls_gdal.cpp.
class GdalCalls {
public:
    explicit GdalCalls(std::stop_token stop = {});
    ~GdalCalls();
    GdalCalls(const GdalCalls&) = delete;
    GdalCalls& operator=(const GdalCalls&) = delete;

    /// True once a call has failed (GDAL's warnings do not count).
    [[nodiscard]] bool failed() const { return failures_ > 0; }
    /// Number of failed calls.
    [[nodiscard]] std::size_t failures() const { return failures_; }
    /// GDAL's messages for every failure and warning, in order; the first 10,000.
    [[nodiscard]] const std::vector<std::string>& complaints() const { return complaints_; }
    /// GDAL's message for the first failure, or "no reason was given".
    [[nodiscard]] const std::string& why() const { return why_; }

private:
    StopScope scope_;
    friend void keepComplaint(GdalCalls& calls, bool failure, const char* words);
    std::size_t failures_ = 0;
    std::vector<std::string> complaints_;
    std::string why_ = "no reason was given";
};

}  // namespace noonmark
