#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace noonmark {

/// RAII guard around calls to GDAL. It makes sure that GDAL is set up for untrusted files (gdal_setup.h), and
/// it collects GDAL's messages on this thread instead of letting GDAL print them. Backend:
/// gdal_calls_gdal.cpp.
class GdalCalls {
public:
    GdalCalls();
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
    friend void keepComplaint(GdalCalls& calls, bool failure, const char* words);
    std::size_t failures_ = 0;
    std::vector<std::string> complaints_;
    std::string why_ = "no reason was given";
};

}  // namespace noonmark
