#include <cpl_conv.h>
#include <cpl_http.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <cpl_vsi_virtual.h>
#include <gdal_frmts.h>
#include <gdal_priv.h>
#include <ogr_srs_api.h>
#include <ogrsf_frmts.h>

#include <array>
#include <string_view>
#include <vector>

#include "core/base/gdal_files.h"
#include "core/base/gdal_setup.h"
#include "core/base/proj_files.h"

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

}  // namespace

void setUpGdal() {
    confineProj();
    confineGdalFiles();
    registerDrivers();
    registerVirtualRasters();
    setOptions();
    CPLHTTPSetFetchCallback(refuseFetch, nullptr);
    closeVirtualFolders();
}

}  // namespace noonmark
