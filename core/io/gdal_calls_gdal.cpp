#include <cpl_error.h>
#include <gdal.h>

#include <mutex>

#include "core/io/gdal_calls.h"

namespace noonmark {

void keepFailure(GdalCalls& calls, const char* words) {
    if (calls.failed_) return;
    calls.failed_ = true;
    if (words != nullptr && *words != '\0') calls.why_ = words;
}

namespace {
void CPL_STDCALL onComplaint(CPLErr kind, CPLErrorNum, const char* words) {
    if (kind >= CE_Failure) keepFailure(*static_cast<GdalCalls*>(CPLGetErrorHandlerUserData()), words);
}
}  // namespace

GdalCalls::GdalCalls() {
    static std::once_flag registered;
    std::call_once(registered, GDALAllRegister);
    CPLPushErrorHandlerEx(onComplaint, this);
    CPLErrorReset();
}

GdalCalls::~GdalCalls() { CPLPopErrorHandler(); }

}  // namespace noonmark
