#pragma once

#include <string>

namespace noonmark {

/// Hold one while calling GDAL: its drivers are registered, and what it complains of on this thread is kept
/// here instead of being printed. Backend: gdal_calls_gdal.cpp.
class GdalCalls {
public:
    GdalCalls();
    ~GdalCalls();
    GdalCalls(const GdalCalls&) = delete;
    GdalCalls& operator=(const GdalCalls&) = delete;

    /// True once a call failed (GDAL's warnings do not count).
    [[nodiscard]] bool failed() const { return failed_; }
    /// GDAL's words for the first failure, or "no reason was given".
    [[nodiscard]] const std::string& why() const { return why_; }

private:
    friend void keepFailure(GdalCalls& calls, const char* words);
    bool failed_ = false;
    std::string why_ = "no reason was given";
};

}  // namespace noonmark
