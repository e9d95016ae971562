#include "core/base/gdal_calls.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_http.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <cpl_vsi_virtual.h>
#include <gdal_frmts.h>
#include <gdal_priv.h>
#include <ogr_srs_api.h>
#include <ogrsf_frmts.h>
#include <algorithm>
#include <array>
#include <memory>
#include <mutex>
#include <string_view>
#include <utility>

namespace noonmark {

namespace {

void registerDrivers() {
    for (const auto& add :
         {GDALRegister_GTiff, GDALRegister_HFA, GDALRegister_AAIGrid, GDALRegister_GRASSASCIIGrid,
          GDALRegister_DTED, GDALRegister_SRTMHGT, GDALRegister_USGSDEM, GDALRegister_EHdr, GDALRegister_XYZ,
          GDALRegister_MEM, GDALRegister_PNG})  // PNG: tiles of integers in a GeoPackage
        add();
    for (const auto& add : {RegisterOGRShape, RegisterOGRGeoJSON, RegisterOGRGeoJSONSeq, RegisterOGRESRIJSON,
                            RegisterOGRTopoJSON, RegisterOGRCSV, RegisterOGRGeoPackage, RegisterOGRFlatGeobuf,
                            RegisterOGROSM, RegisterOGRGML, RegisterOGRKML, RegisterOGROpenFileGDB,
                            RegisterOGRMEM, RegisterOGRDXF})  // written only: no reader allows it
        add();
}

// Readers extract bands of rasters through virtual rasters in memory: those are created here and never opened
// from a file.
void registerVirtualRasters() {
    GDALRegister_VRT();
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("VRT");
    driver->pfnOpen = nullptr;
    driver->pfnIdentify = nullptr;
}

// Options take precedence over environment variables of the same names.
void setOptions() {
    constexpr std::array<std::array<const char*, 2>, 7> options{{
        {"CPL_VSIL_CURL_ALLOWED_EXTENSIONS", "{no file is read from the network}"},
        {"GDAL_HTTP_MAX_RETRY", "0"},
        {"GML_SKIP_RESOLVE_ELEMS", "ALL"},
        {"GML_DOWNLOAD_WFS_SCHEMA", "NO"},
        {"OGR_SQLITE_LOAD_EXTENSIONS", nullptr},
        {"OGR_SQLITE_PRAGMA", nullptr},
        {"OGR_GEOJSON_MAX_OBJ_SIZE", "20"},  // MB of one feature: a ring of a million points
    }};
    for (const auto& [name, value] : options) CPLSetConfigOption(name, value);
    OSRSetPROJEnableNetwork(FALSE);
}

CPLHTTPResult* refuseFetch(const char* address, CSLConstList, GDALProgressFunc, void*, CPLHTTPFetchWriteFunc,
                           void*, void*) {
    CPLError(CE_Failure, CPLE_OpenFailed, "%s: nothing is read from the network", address);
    auto* result = static_cast<CPLHTTPResult*>(CPLCalloc(1, sizeof(CPLHTTPResult)));
    result->nStatus = 1;
    result->pszErrBuf = CPLStrdup("nothing is read from the network");
    return result;
}

void* refuseFile(void*, const char* name, const char*) {
    CPLError(CE_Failure, CPLE_OpenFailed, "%s: only plain files are read", name);
    return nullptr;
}
int refuseStat(void*, const char*, VSIStatBufL*, int) { return -1; }

// Every virtual folder but /vsimem/. GDAL keeps pointers to the prefixes that it is given, and forgets the
// handlers that are replaced without deleting them: both stay to the end of the process.
void closeVirtualFolders() {
    static char** const prefixes = VSIGetFileSystemsPrefixes();
    static auto& replaced = *new std::vector<const VSIFilesystemHandler*>;
    VSIFilesystemPluginCallbacksStruct* closed = VSIAllocFilesystemPluginCallbacksStruct();
    closed->open = refuseFile;
    closed->stat = refuseStat;
    for (char** prefix = prefixes; prefix != nullptr && *prefix != nullptr; ++prefix) {
        if (std::string_view(*prefix) == "/vsimem/") continue;
        replaced.push_back(VSIFileManager::GetHandler(*prefix));
        VSIInstallPluginHandler(*prefix, closed);
    }
    VSIFreeFilesystemPluginCallbacksStruct(closed);
}

/// Prepares GDAL for untrusted files, once in the process (GdalCalls calls it):
/// - Only the drivers that Noonmark reads and writes with are registered. None of them runs SQL or code from
///   a file, and none connects to a server. This also limits what GDAL opens on its own, such as overviews
///   that a raster names.
/// - GDAL and PROJ have no network access.
/// - Of GDAL's virtual file systems only /vsimem/ remains: no archives, no web or cloud storage, no standard
///   input. On disk it reads plain files only (gdal_calls.h).
/// - PROJ opens the files of its own folders only (gdal_calls.h).
/// - What GDAL says on threads of its own, which pack and unpack rasters and have no GdalCalls, goes nowhere
///   instead of to stderr: the call that they work for fails if they do.
///
/// Backend: gdal_calls_gdal.cpp.
void setUpGdal() {
    CPLSetErrorHandler(CPLQuietErrorHandler);
    confineProj();
    confineGdalFiles();
    registerDrivers();
    registerVirtualRasters();
    setOptions();
    CPLHTTPSetFetchCallback(refuseFetch, nullptr);
    closeVirtualFolders();
}

// A file on disk that ends when the work is stopped.
class StoppableFile final : public VSIVirtualHandle {
public:
    explicit StoppableFile(VSIVirtualHandle* file) : file_(file) {}

    int Seek(vsi_l_offset to, int from) override { return file_->Seek(to, from); }
    vsi_l_offset Tell() override { return file_->Tell(); }
    std::size_t Read(void* bytes, std::size_t size, std::size_t count) override {
        if (!StopScope::isStopped()) return file_->Read(bytes, size, count);
        ended_ = true;
        return 0;
    }
    std::size_t Write(const void* bytes, std::size_t size, std::size_t count) override {
        return file_->Write(bytes, size, count);
    }
    int Eof() override { return ended_ ? 1 : file_->Eof(); }
    int Flush() override { return file_->Flush(); }
    int Close() override { return file_->Close(); }
    int Truncate(vsi_l_offset size) override { return file_->Truncate(size); }
    void* GetNativeFileDescriptor() override { return file_->GetNativeFileDescriptor(); }
    VSIRangeStatus GetRangeStatus(vsi_l_offset offset, vsi_l_offset length) override {
        return file_->GetRangeStatus(offset, length);
    }
    bool HasPRead() const override { return file_->HasPRead(); }
    std::size_t PRead(void* bytes, std::size_t size, vsi_l_offset offset) const override {
        return StopScope::isStopped() ? 0 : file_->PRead(bytes, size, offset);
    }

private:
    std::unique_ptr<VSIVirtualHandle> file_;
    bool ended_ = false;
};

bool isPipeOrDevice(const char* name) {
    std::error_code error;
    const auto status = std::filesystem::status(name, error);
    return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
           !std::filesystem::is_directory(status);
}

thread_local const GdalFolderScope* folderOfThread = nullptr;

// Where GDAL keeps its tables of coordinate systems and known schemas; empty if it finds none.
const std::filesystem::path& folderOfTables() {
    static const std::filesystem::path folder = [] {
        const char* const found = CPLFindFile("gdal", "gml_registry.xml");
        return found != nullptr ? std::filesystem::absolute(found).lexically_normal().parent_path()
                                : std::filesystem::path();
    }();
    return folder;
}

bool liesIn(const std::filesystem::path& folder, const std::filesystem::path& file) {
    return !folder.empty() && std::ranges::mismatch(folder, file).in1 == folder.end();
}

// The file system of the operating system, of which only plain files are opened.
class PlainFiles final : public VSIFilesystemHandler {
public:
    explicit PlainFiles(VSIFilesystemHandler* disk) : disk_(disk) {}

    VSIVirtualHandle* Open(const char* name, const char* access, bool setError,
                           CSLConstList options) override {
        if (isPipeOrDevice(name) || !GdalFolderScope::admits(name)) {
            CPLError(CE_Failure, CPLE_OpenFailed, "%s: only plain files beside the data are read", name);
            return nullptr;
        }
        VSIVirtualHandle* file = disk_->Open(name, access, setError, options);
        return file != nullptr ? new StoppableFile(file) : nullptr;
    }
    int Stat(const char* name, VSIStatBufL* status, int flags) override {
        return disk_->Stat(name, status, flags);
    }
    int Unlink(const char* name) override { return disk_->Unlink(name); }
    int Mkdir(const char* name, long mode) override { return disk_->Mkdir(name, mode); }
    int Rmdir(const char* name) override { return disk_->Rmdir(name); }
    char** ReadDirEx(const char* folder, int maximum) override { return disk_->ReadDirEx(folder, maximum); }
    int Rename(const char* from, const char* to) override { return disk_->Rename(from, to); }
    int IsCaseSensitive(const char* name) override { return disk_->IsCaseSensitive(name); }
    GIntBig GetDiskFreeSpace(const char* folder) override { return disk_->GetDiskFreeSpace(folder); }
    int SupportsSparseFiles(const char* name) override { return disk_->SupportsSparseFiles(name); }

private:
    std::unique_ptr<VSIFilesystemHandler> disk_;
};

}  // namespace

GdalFolderScope::GdalFolderScope(const std::filesystem::path& folder)
    : folder_(std::filesystem::absolute(folder).lexically_normal()), outer_(folderOfThread) {
    if (!folder_.has_filename()) folder_ = folder_.parent_path();  // it was named with a slash at its end
    (void)folderOfTables();  // found before it is needed: GDAL looks for it among files
    folderOfThread = this;
}

GdalFolderScope::~GdalFolderScope() { folderOfThread = outer_; }

bool GdalFolderScope::admits(const std::filesystem::path& file) {
    if (folderOfThread == nullptr) return true;
    const auto name = std::filesystem::absolute(file).lexically_normal();
    return liesIn(folderOfThread->folder_, name) || liesIn(folderOfTables(), name);
}

void confineGdalFiles() {
    VSIFileManager::InstallHandler("", new PlainFiles(VSIFileManager::GetHandler("")));  // GDAL deletes it
}

void keepMessage(GdalCalls& calls, bool failure, const char* words) {
    constexpr std::size_t maximum = 10000;
    const std::string text = words != nullptr ? words : "";
    if (calls.complaints_.size() < maximum) calls.complaints_.push_back(text);
    if (!failure) return;
    if (calls.failures_++ == 0 && !text.empty()) calls.why_ = text;
}

namespace {
void CPL_STDCALL onComplaint(CPLErr kind, CPLErrorNum, const char* words) {
    if (kind < CE_Warning) return;
    keepMessage(*static_cast<GdalCalls*>(CPLGetErrorHandlerUserData()), kind >= CE_Failure, words);
}
}  // namespace

int continueUnlessStopped(double /*share*/, const char* /*message*/, void* stop) {
    return static_cast<const std::stop_token*>(stop)->stop_requested() ? FALSE : TRUE;
}

GdalCalls::GdalCalls(std::stop_token stop) : scope_(std::move(stop)) {
    static std::once_flag prepared;
    std::call_once(prepared, setUpGdal);
    CPLPushErrorHandlerEx(onComplaint, this);
    CPLErrorReset();
}

GdalCalls::~GdalCalls() { CPLPopErrorHandler(); }

}  // namespace noonmark
