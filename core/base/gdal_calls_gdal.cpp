#include <cpl_error.h>

#include <mutex>
#include <utility>

#include "core/base/gdal_calls.h"
#include "core/base/gdal_setup.h"

namespace noonmark {

void keepComplaint(GdalCalls& calls, bool failure, const char* words) {
    constexpr std::size_t most = 10000;
    const std::string text = words != nullptr ? words : "";
    if (calls.complaints_.size() < most) calls.complaints_.push_back(text);
    if (!failure) return;
    if (calls.failures_++ == 0 && !text.empty()) calls.why_ = text;
}

namespace {
void CPL_STDCALL onComplaint(CPLErr kind, CPLErrorNum, const char* words) {
    if (kind < CE_Warning) return;
    keepComplaint(*static_cast<GdalCalls*>(CPLGetErrorHandlerUserData()), kind >= CE_Failure, words);
}
}  // namespace

GdalCalls::GdalCalls(std::stop_token stop) : scope_(std::move(stop)) {
    static std::once_flag prepared;
    std::call_once(prepared, setUpGdal);
    CPLPushErrorHandlerEx(onComplaint, this);
    CPLErrorReset();
}

GdalCalls::~GdalCalls() { CPLPopErrorHandler(); }

}  // namespace noonmark
