#include "core/io/heights/field_roles.h"

#include <array>

namespace noonmark {

namespace {

// Sources: the producers' own descriptions of the datasets named in the comments. Omitted on purpose: z_min
// and z_max, which in BD TOPO 2 are both elevations of the gutter; story_ht_, which is the height of one
// storey or of all.
constexpr auto listedFieldNames() {
    using enum FieldRole;
    constexpr auto m = LengthUnit::metres;
    constexpr auto cm = LengthUnit::centimetres;
    constexpr auto ft = LengthUnit::feet;
    constexpr std::nullopt_t other = std::nullopt;

    constexpr std::string_view top = "highest point";
    constexpr std::string_view base = "base of the roof";
    constexpr std::string_view median = "median of the roof";
    constexpr std::string_view mean = "mean of the roof";
    constexpr std::string_view p70 = "70th percentile of the roof";
    constexpr std::string_view p99 = "99th percentile of the roof";

    return std::to_array<FieldName>({
        // Heights above the ground that many datasets use.
        {"height", height},
        {"buildingheight", height},
        {"measuredheight", height},
        {"bldgmeasuredheight", height},  // PLATEAU, Japan
        {"heightroof", height, "", {}, "New York"},
        {"bldgheight", height},
        {"bldght", height},
        {"bldghgt", height},
        {"renderheight", height},
        {"hgt", height},
        {"heightaboveground", height},          // INSPIRE
        {"hgtagl", height, "", {}},             // Vancouver, HGT_AGL
        {"bldghgt2010", height, "", ft},        // Boston
        {"structureextrusion", height, "", m},  // Melbourne
        {"approxhgt", height, "", ft},          // Philadelphia
        {"elevgl", height, "", ft},             // Cambridge, Massachusetts: the main roof above the ground
        {"hauteur", height, base, m},           // BD TOPO, France: up to the gutter
        {"hoehe", height},
        {"gebaeudehoehe", height},
        {"gebhoehe", height},
        {"hoh", height, "", m},  // ALKIS: height of the object
        {"objekthoehe", height},
        {"gesamthoehe", height, top, m},  // swissBUILDINGS3D
        {"altura", height},
        {"edaltura", height},
        {"altezza", height},
        {"unvolav", height, "", m},  // Italy's DBGT, UN_VOL_AV
        {"vyska", height},
        {"korkeus", height},
        {"korgus", height},
        {"hoogte", height},

        // Statistics of the roof above the ground, typical values first.
        {"hgtmedianm", height, median, m},  // San Francisco
        {"hgtmediancm", height, median, cm},
        {"hgtmincm", other},
        {"hgtmaxcm", other},
        {"medianheight", height, median},
        {"heightmedian", height, median},
        {"hmedian", height, median},
        {"hmed", height, median, m},  // APUR, Paris
        {"avgheight", height, mean, {}, "Portland, Oregon"},
        {"heightavg", height, mean},
        {"avght", height, mean},  // Vancouver, AVGHT_M
        {"meanheight", height, mean},
        {"heightmean", height, mean},
        {"mittlhoehe", height, mean, m},
        {"mittlerehoehe", height, mean},
        {"hmean", height, mean},
        {"hmoy", height, mean, m},
        {"relh2", height, base, m},  // OS MasterMap Building Height Attribute, Great Britain
        {"heightrelativeroofbase", height, base, m},
        {"eaveheight", height, base},
        {"hnp99", height, p99, m},  // 3D GRB, Flanders
        {"relhmax", height, top, m},
        {"heightrelativemax", height, top, m},
        {"hnmax", height, top, m},
        {"topgl", height, top, ft},  // Cambridge, Massachusetts
        {"maxheight", height, top, {}, "Portland, Oregon"},
        {"heightmax", height, top},
        {"maxhgt", height, top, {}, "Philadelphia"},
        {"maxht", height, top},
        {"hmax", height, top},

        // Elevations of roofs: the height is the difference from the ground's elevation.
        {"b3hdak70p", topElevation, p70,
         m},  // 3DBAG, Netherlands, above NAP; its own block models are extruded to this
        {"b3h70p", topElevation, p70, m},
        {"hdak70p", topElevation, p70, m},
        {"b3hdak50p", topElevation, median, m},
        {"b3h50p", topElevation, median, m},
        {"hdak50p", topElevation, median, m},
        {"roof075", topElevation, "75th percentile of the roof", m},  // 3dfier, "roof-0.75"
        {"roof050", topElevation, median, m},
        {"median1stm", topElevation, median, m},  // San Francisco
        {"hdsmp99", topElevation, p99, m},        // 3D GRB
        {"absh2", topElevation, base, m},         // OS MasterMap
        {"heightabsoluteroofbase", topElevation, base, m},
        {"zmintoit", topElevation, base, m},  // BD TOPO
        {"altitudeminimaletoit", topElevation, base, m},
        {"unvolqgr", topElevation, base, m},  // DBGT: quota di gronda
        {"unvolqg", topElevation, base, m},
        {"roofelev2010", topElevation, "", ft},  // Boston
        {"roofelevation", topElevation},
        {"roofelev", topElevation},
        {"topelev", topElevation},            // Vancouver, TOPELEV_M
        {"topheight", topElevation, "", m},   // Hong Kong, above the principal datum
        {"rooflevel", topElevation, "", m},   // Hong Kong, iB1000
        {"okote", topElevation, "", m},       // Vienna's Flaechenmehrzweckkarte
        {"hoehedach", topElevation, top, m},  // LoD2-DE
        {"dachmax", topElevation, top, m},    // swissBUILDINGS3D
        {"hnhn", topElevation, "", m},
        {"heightmsl", topElevation, top, {}},  // Toronto
        {"b3hdakmax", topElevation, top, m},
        {"b3hmax", topElevation, top, m},
        {"hdakmax", topElevation, top, m},
        {"b3hnok", topElevation, "ridge", m},
        {"hdsmmax", topElevation, top, m},
        {"abshmax", topElevation, top, m},
        {"heightabsolutemax", topElevation, top, m},
        {"zmaxtoit", topElevation, "ridge", m},
        {"altitudemaximaletoit", topElevation, "ridge", m},
        {"unvolqe", topElevation, top, m},
        {"dachmin", other},
        {"b3hdakmin", other},
        {"hdakmin", other},

        // Storeys above the ground.
        {"buildinglevels", levels},
        {"levels", levels},
        {"numfloors", levels},
        {"numberoffloors", levels},
        {"numberoffloorsaboveground", levels},  // INSPIRE
        {"numberoffloorsbelowground", other},
        {"heightbelowground", other},
        {"nfloors", levels},
        {"nofloors", levels},
        {"floors", levels},
        {"floorcount", levels},
        {"numstories", levels},
        {"numstory", levels},
        {"numberofstories", levels},
        {"nostories", levels},  // Chicago
        {"stories", levels},
        {"bldgstories", levels},
        {"storeys", levels},
        {"numstoreys", levels},
        {"storeysaboveground", levels},
        {"bldgstoreysaboveground", levels},
        {"storeysbelowground", other},
        {"bldgstoreysbelowground", other},
        {"maxfloorlvl", levels},  // Singapore
        {"grofloco", levels},     // Korea: GRO_FLO_CO, and UND_FLO_CO below the ground
        {"nbetages", levels},     // BD TOPO: includes the ground floor
        {"nombredetages", levels},
        {"nbniveaux", levels},
        {"anzahlgeschosse", levels},
        {"anzahlderoberirdischengeschosse", levels},
        {"anzahlderunterirdischengeschosse", other},
        {"aog", levels},       // ALKIS
        {"gastw", levels},     // Switzerland's register of buildings
        {"anzahlgs", levels},  // ALKIS, simplified
        {"geschosse", levels},
        {"geschosszahl", levels},
        {"vollgeschosse", levels},
        {"numpisos", levels},
        {"npisos", levels},
        {"numeropisos", levels},
        {"connpisos", levels},  // Bogota
        {"pisos", levels},
        {"plantas", levels},
        {"numplantas", levels},
        {"pavimentos", levels},
        {"numpiani", levels},
        {"npiani", levels},
        {"b3bouwlagen", levels},
        {"bouwlagen", levels},
        {"antaletager", levels},  // Denmark
        {"byg054antaletager", levels},
        {"antalletasjer", levels},
        {"antalvaningar", levels},
        {"kerrosluku", levels},
        {"kerrostenlkm", levels},
        {"liczbakondygnacji", levels},
        {"liczbakondygnacjinadziemnych", levels},
        {"liczbakondygnacjipodziemnych", other},
        {"pocetpodlazi", levels},
        {"pocetnadzemnichpodlazi", levels},
        {"korrustearv", levels},
        {"maxkorrustearv", levels},
        {"floor", levels},  // building outlines of cities in China and Taiwan

        // The underside of a part.
        {"minheight", minHeight},
        {"buildingminheight", minHeight},
        {"renderminheight", minHeight},
        {"baseheight", minHeight},
        {"buildingminlevel", minLevel},
        {"ukote", bottomElevation, "", m},  // Vienna, of passages and what is built over streets
        {"minlevel", minLevel},
        {"minfloor", minLevel},
        {"roofheight", roofHeight},
        {"rooflevels", roofLevels},
        {"roofshape", roofShape},

        // Elevations of the ground.
        {"groundelevation", groundElevation},
        {"groundelev", groundElevation, "", {}, "New York"},
        {"groundz", groundElevation},
        {"grndelev2010", groundElevation, "", ft},
        {"grndelev", groundElevation},
        {"gndminm", groundElevation, "", m},
        {"gndmincm", groundElevation, "", cm},
        {"abshmin", groundElevation, "", m},
        {"heightabsolutemin", groundElevation, "", m},
        {"b3hmaaiveld", groundElevation, "", m},
        {"hmaaiveld", groundElevation, "", m},
        {"ground000", groundElevation, "", m},
        {"hdtmmin", groundElevation, "", m},
        {"hoehegrund", groundElevation, "", m},
        {"gelaendepunkt", groundElevation, "", m},
        {"tkote", groundElevation, "", m},
        {"zminsol", groundElevation, "", m},
        {"altitudeminimalesol", groundElevation, "", m},
        {"zmaxsol", groundElevation, "", m},
        {"altitudemaximalesol", groundElevation, "", m},
        {"unvolqb", groundElevation, "", m},
        {"surfelev", groundElevation, "", {}, "Portland, Oregon"},
        {"surfaceelevation", other},  // URBANopt: in feet beside heights in metres
        {"baseelev", groundElevation},
        {"baselevel", groundElevation, "", m},  // Hong Kong, iB1000
        {"baseelevation", groundElevation, "", {}, "Philadelphia"},

        // What kind of object a feature is.
        {"building", building},
        {"buildingpart", buildingPart},
        {"location", location},
        {"layer", layer},
        {"level", level},
        {"tunnel", tunnel},
        {"entrance", entrance},
        {"underground", underground},
        {"isunderground", underground},
        {"sourceid", id},
        {"id", id},
        {"osmid", id},
        {"gmlid", id},
        {"globalid", id},
        {"objectid", id},
        {"buildingid", buildingId},
        {"name", name},
        {"buildingname", name},
        {"bldgname", name},
        {"status", status},
        {"heightsource", heightSource},
        {"hangs", isOverhanging},
    });
}

constexpr auto allFieldNames = listedFieldNames();

}  // namespace

std::span<const FieldName> listFieldNames() { return allFieldNames; }

}  // namespace noonmark
