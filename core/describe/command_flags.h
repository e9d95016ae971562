#pragma once

/// Flags of noonmark-cli that no table of fields has, and that repeat commands or messages name all the same.
namespace noonmark::flags {

inline constexpr const char* out = "--out";
inline constexpr const char* overwrite = "--overwrite";
inline constexpr const char* json = "--json";
inline constexpr const char* save = "--save";
inline constexpr const char* keep = "--keep";
inline constexpr const char* scenario = "--scenario";
inline constexpr const char* baseline = "--baseline";
inline constexpr const char* from = "--from";  ///< scenario that another is compared with
inline constexpr const char* to = "--to";
inline constexpr const char* places = "--places";
inline constexpr const char* rule = "--rule";
inline constexpr const char* rules = "--rules";  ///< folder of the user's own rules
inline constexpr const char* choose = "--choose";
inline constexpr const char* year = "--year";
inline constexpr const char* tile = "--tile";
inline constexpr const char* partial = "--partial";
inline constexpr const char* threshold =
    "--threshold";  ///< of a change, minutes a day; of colours of places, hours
inline constexpr const char* byBuilding = "--by-building";
inline constexpr const char* weights = "--weights";  ///< table of a score

}  // namespace noonmark::flags
