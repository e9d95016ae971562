#include "core/io/heights/tree_fields.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>

#include "core/describe/text.h"
#include "core/io/heights/height_text.h"
#include "core/sun/civil_time.h"

namespace noonmark {

namespace {

constexpr auto cm = LengthUnit::centimetres, in = LengthUnit::inches, ft = LengthUnit::feet,
               m = LengthUnit::metres;

// Vienna's classes, from the description of its register of trees: 0 is unknown.
constexpr std::array viennaHeights{0.0, 2.5, 8.0, 13.0, 18.0, 23.0, 28.0, 33.0, 37.0};
constexpr std::array viennaCrowns{0.0, 1.5, 5.0, 8.0, 11.0, 14.0, 17.0, 20.0, 23.0};

// Sources: the descriptions of the inventories that the comments name.
constexpr std::array listedTreeFields{
    TreeFieldName{"baumhoehe", TreeRole::height, m, "gattungart", viennaHeights},
    TreeFieldName{"baumhoehe", TreeRole::height, m},    // Berlin
    TreeFieldName{"treeheight", TreeRole::height, ft},  // Seattle
    TreeFieldName{"hauteurenm", TreeRole::height, m},   // Paris
    TreeFieldName{"hauteurm", TreeRole::height, m},     // its table
    TreeFieldName{"hauteur", TreeRole::height, m},
    TreeFieldName{"hoehem", TreeRole::height, m},
    TreeFieldName{"heightm", TreeRole::height, m},
    TreeFieldName{"heightft", TreeRole::height, ft},
    TreeFieldName{"treeheightm", TreeRole::height, m},
    TreeFieldName{"height", TreeRole::height, m},
    TreeFieldName{"estheight", TreeRole::height, m},
    TreeFieldName{"averageheight", TreeRole::height, m},  // PlantCover of CityGML
    TreeFieldName{"hoehe", TreeRole::height, m},
    TreeFieldName{"altura", TreeRole::height, m},
    TreeFieldName{"altezza", TreeRole::height, m},
    TreeFieldName{"hoogte", TreeRole::height, m},
    TreeFieldName{"boomhoogte", TreeRole::height, m},
    TreeFieldName{"kronendurchmesser", TreeRole::crownDiameter, m, "gattungart", viennaCrowns},
    TreeFieldName{"kronendurchmesser", TreeRole::crownDiameter, m},  // Zurich, Hamburg
    TreeFieldName{"kronedurch", TreeRole::crownDiameter, m},         // Berlin
    TreeFieldName{"diametercrown", TreeRole::crownDiameter, m},      // OpenStreetMap
    TreeFieldName{"crowndiameter", TreeRole::crownDiameter, m},
    TreeFieldName{"crowndiam", TreeRole::crownDiameter, m},
    TreeFieldName{"crownwidth", TreeRole::crownDiameter, m},
    TreeFieldName{"crownspread", TreeRole::crownDiameter, m},
    TreeFieldName{"crownm", TreeRole::crownDiameter, m},
    TreeFieldName{"kronem", TreeRole::crownDiameter, m},
    TreeFieldName{"crownbase", TreeRole::crownBase, m},
    TreeFieldName{"crownbasem", TreeRole::crownBase, m},
    TreeFieldName{"treedbh", TreeRole::stemDiameter, in},               // New York
    TreeFieldName{"dbh", TreeRole::stemDiameter, in, "qspecies"},       // San Francisco
    TreeFieldName{"dbhtrunk", TreeRole::stemDiameter, cm},              // Toronto
    TreeFieldName{"dhp", TreeRole::stemDiameter, cm},                   // Montreal
    TreeFieldName{"diam", TreeRole::stemDiameter, in, "treeheight"},    // Seattle
    TreeFieldName{"diameterbreastheight", TreeRole::stemDiameter, cm},  // Melbourne
    TreeFieldName{"trunkdiameter", TreeRole::stemDiameter, m},          // CityGML, CityJSON
    TreeFieldName{"dbhcm", TreeRole::stemDiameter, cm},
    TreeFieldName{"dbhin", TreeRole::stemDiameter, in},
    TreeFieldName{"dbhinches", TreeRole::stemDiameter, in},
    TreeFieldName{"dbh", TreeRole::stemDiameter, cm, "", {}, true},
    TreeFieldName{"circonferenceencm", TreeRole::stemGirth, cm},  // Paris
    TreeFieldName{"circonferencecm", TreeRole::stemGirth, cm},    // its table
    TreeFieldName{"stammumfang", TreeRole::stemGirth, cm},        // Vienna
    TreeFieldName{"stammumfg", TreeRole::stemGirth, cm},          // Berlin
    TreeFieldName{"circumference", TreeRole::stemGirth, m},       // OpenStreetMap
    TreeFieldName{"genus", TreeRole::genus},
    TreeFieldName{"genre", TreeRole::genus},  // Paris
    TreeFieldName{"gattung", TreeRole::genus},
    TreeFieldName{"baumgattunglat", TreeRole::genus},  // Zurich
    TreeFieldName{"gattunglatein", TreeRole::genus},   // Hamburg
    TreeFieldName{"espece", TreeRole::epithet, m, "genre"},
    TreeFieldName{"baumartlat", TreeRole::epithet, m, "baumgattunglat"},
    TreeFieldName{"spclatin", TreeRole::species},        // New York
    TreeFieldName{"qspecies", TreeRole::species},        // San Francisco
    TreeFieldName{"artbot", TreeRole::species},          // Berlin
    TreeFieldName{"gattungart", TreeRole::species},      // Vienna
    TreeFieldName{"baumnamelat", TreeRole::species},     // Zurich
    TreeFieldName{"essencelatin", TreeRole::species},    // Montreal
    TreeFieldName{"scientificname", TreeRole::species},  // Melbourne, Seattle
    TreeFieldName{"scientific", TreeRole::species},
    TreeFieldName{"botanicalname", TreeRole::species},  // Toronto
    TreeFieldName{"artlatein", TreeRole::species},      // Hamburg
    TreeFieldName{"latinname", TreeRole::species},
    TreeFieldName{"taxon", TreeRole::species},
    TreeFieldName{"species", TreeRole::species},
    TreeFieldName{"leafcycle", TreeRole::leafCycle},   // OpenStreetMap
    TreeFieldName{"leaftype", TreeRole::leafType},     // OpenStreetMap
    TreeFieldName{"baumtyptext", TreeRole::leafType},  // Zurich
    TreeFieldName{"baumtyp", TreeRole::leafType},
    TreeFieldName{"leafonday", TreeRole::leafOnDay},  // projects
    TreeFieldName{"leafoffday", TreeRole::leafOffDay},
    TreeFieldName{"status", TreeRole::status},  // New York
    TreeFieldName{"treestatus", TreeRole::status},
    TreeFieldName{"currentstatus", TreeRole::status},    // Seattle
    TreeFieldName{"pflanzjahr", TreeRole::planted},      // Berlin, Vienna, Hamburg, Zurich
    TreeFieldName{"standalter", TreeRole::planted},      // Berlin
    TreeFieldName{"yearplanted", TreeRole::planted},     // Melbourne
    TreeFieldName{"plantdate", TreeRole::planted},       // San Francisco
    TreeFieldName{"planteddate", TreeRole::planted},     // Seattle
    TreeFieldName{"dateplantation", TreeRole::planted},  // Montreal
    TreeFieldName{"anneeplantation", TreeRole::planted},
    TreeFieldName{"plantingyear", TreeRole::planted},
    TreeFieldName{"longitude", TreeRole::longitude},
    TreeFieldName{"shapelng", TreeRole::longitude},  // Seattle
    TreeFieldName{"lon", TreeRole::longitude},
    TreeFieldName{"lng", TreeRole::longitude},
    TreeFieldName{"latitude", TreeRole::latitude},
    TreeFieldName{"shapelat", TreeRole::latitude},  // Seattle
    TreeFieldName{"lat", TreeRole::latitude},
    TreeFieldName{"geopoint2d", TreeRole::latLon},  // Paris and others of Opendatasoft
    TreeFieldName{"x", TreeRole::easting},          // tables of ArcGIS Hub
    TreeFieldName{"easting", TreeRole::easting},
    TreeFieldName{"rechtswert", TreeRole::easting},
    TreeFieldName{"y", TreeRole::northing},
    TreeFieldName{"northing", TreeRole::northing},
    TreeFieldName{"hochwert", TreeRole::northing},
};

constexpr std::array treeRoles{
    TreeRoleEntry{TreeRole::height, "height", NM_TEXT("Height"), true},
    TreeRoleEntry{TreeRole::crownDiameter, "crown", NM_TEXT("Crown diameter"), true},
    TreeRoleEntry{TreeRole::crownBase, "crown-base", NM_TEXT("Crown base"), true},
    TreeRoleEntry{TreeRole::stemDiameter, "stem", NM_TEXT("Stem diameter"), true},
    TreeRoleEntry{TreeRole::stemGirth, "girth", NM_TEXT("Stem girth"), true},
    TreeRoleEntry{TreeRole::species, "species", NM_TEXT("Species")},
    TreeRoleEntry{TreeRole::genus, "genus", NM_TEXT("Genus")},
    TreeRoleEntry{TreeRole::leafCycle, "leaf-cycle", NM_TEXT("Leaf cycle")},
    TreeRoleEntry{TreeRole::leafOnDay, "leaf-on", NM_TEXT("First day in leaf")},
    TreeRoleEntry{TreeRole::leafOffDay, "leaf-off", NM_TEXT("First day without leaves")},
};

// In small letters, without what is no letter or digit.
std::string plainName(std::string_view name) {
    std::string plain;
    for (const unsigned char letter : name)
        if (std::isalnum(letter) != 0) plain += char(std::tolower(letter));
    return plain;
}

// German and French letters of field names.
std::string withoutAccents(std::string name) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 8> letters{{{"ö", "oe"},
                                                                                    {"Ö", "oe"},
                                                                                    {"ä", "ae"},
                                                                                    {"ü", "ue"},
                                                                                    {"é", "e"},
                                                                                    {"è", "e"},
                                                                                    {"ê", "e"},
                                                                                    {"ß", "ss"}}};
    for (const auto& [accented, plain] : letters)
        for (auto at = name.find(accented); at != name.npos; at = name.find(accented))
            name.replace(at, accented.size(), plain);
    return name;
}

bool isIn(const std::vector<std::string>& names, std::string_view name) {
    return std::ranges::find(names, name) != names.end();
}

bool contains(std::string_view text, std::initializer_list<std::string_view> words) {
    return std::ranges::any_of(words, [&](std::string_view word) { return text.find(word) != text.npos; });
}

/// Reads the values of one tree.
class TreeValues {
public:
    TreeValues(std::span<const KnownTreeField> fields, std::span<const std::string> values,
               const std::string& where, Warnings& warnings)
        : fields_(fields), values_(values), where_(where), warnings_(warnings) {}

    [[nodiscard]] std::string_view text(TreeRole role) const {
        const KnownTreeField* field = findRole(fields_, role);
        return field == nullptr ? std::string_view() : std::string_view(values_[field->index]);
    }

    std::optional<double> length(TreeRole role, bool (*plausible)(double), double factor = 1) {
        const KnownTreeField* field = findRole(fields_, role);
        const std::string_view written = text(role);
        if (field == nullptr || written.empty()) return std::nullopt;
        const auto metres = read(field->meaning, written);
        if (metres && *metres == 0) return noteZero(*field);
        if (metres && plausible(*metres * factor)) return *metres * factor;
        warnings_.push_back(
            {WarningKind::leftOut,
             metres ? "a measure of a tree that no tree has" : "a measure of a tree that is no number",
             where_ + ": " + field->field + " " + std::string(written)});
        return std::nullopt;
    }

    std::optional<int> day(TreeRole role) {
        const std::string_view written = text(role);
        if (written.empty() || written == "0") return std::nullopt;
        if (const auto day = readDay(written)) return day;
        warnings_.push_back({WarningKind::leftOut, "a leaf day of a tree that is no day of the year",
                             where_ + ": " + findRole(fields_, role)->field + " " + std::string(written)});
        return std::nullopt;
    }

    // Of a tree without any measure.
    void notePlanting() {
        const std::string_view written = text(TreeRole::planted);
        if (written.empty() || written == "0") return;
        warnings_.push_back(
            {WarningKind::assumed,
             "a tree has a year of planting or an age and no size; its size is the default of its genus",
             where_ + ": " + findRole(fields_, TreeRole::planted)->field + " " + std::string(written)});
    }

private:
    std::nullopt_t noteZero(const KnownTreeField& field) {
        warnings_.push_back({WarningKind::assumed, "a measure of a tree is 0 and counts as not stated",
                             where_ + ": " + field.field});
        return std::nullopt;
    }

    // "04-15", "2026-04-15", "2026/04/15 00:00:00" (columns of dates), or the number of a day.
    static std::optional<int> readDay(std::string_view written) {
        constexpr std::size_t dateLetters = 10;
        std::string dashed(written);
        std::ranges::replace(dashed, '/', '-');
        if (const auto date = parseDate(dashed.substr(0, dateLetters))) return dayOfCommonYear(*date);
        if (const auto day = parseDayOfYear(dashed)) return *day;
        const auto number = parseLevels(written);
        const bool isDay = number && *number >= 1 && *number <= 366 && *number == std::floor(*number);
        return isDay ? std::optional(int(*number)) : std::nullopt;
    }

    static std::optional<double> read(const TreeFieldName& meaning, std::string_view written) {
        if (meaning.classes.empty()) return parseTreeLength(written, meaning.unit);
        const auto number = parseLevels(written);
        if (!number || *number < 0 || *number >= double(meaning.classes.size())) return std::nullopt;
        return meaning.classes[std::size_t(*number)];
    }

    std::span<const KnownTreeField> fields_;
    std::span<const std::string> values_;
    const std::string& where_;
    Warnings& warnings_;
};

// Words for a species that is not known: San Francisco writes "Tree(s) ::", Paris "n. sp.".
bool isNoSpecies(std::string_view name) {
    constexpr std::array<std::string_view, 8> none{"trees",     "tree", "unknown",      "unidentified",
                                                   "unbekannt", "nsp",  "nichtbekannt", "inconnu"};
    return std::ranges::find(none, plainName(name)) != none.end();
}

// "Platanus x hispanica :: London plane": the Latin name comes first.
std::string nameSpecies(const TreeValues& values) {
    std::string_view whole = values.text(TreeRole::species);
    whole = whole.substr(0, whole.find("::"));
    while (!whole.empty() && whole.back() == ' ') whole.remove_suffix(1);
    const std::string_view genus = values.text(TreeRole::genus), epithet = values.text(TreeRole::epithet);
    if (isNoSpecies(whole)) whole = {};
    if (genus.empty() || plainName(whole).starts_with(plainName(genus))) return std::string(whole);
    const std::string_view second = epithet.empty() ? whole : epithet;
    return std::string(genus) + (second.empty() ? "" : " ") + std::string(second);
}

std::optional<bool> readEvergreen(std::string_view cycle) {
    const std::string plain = plainName(cycle);
    if (contains(plain, {"evergreen", "immergruen"})) return true;
    if (contains(plain, {"deciduous"})) return false;
    return std::nullopt;
}

std::optional<bool> readNeedles(std::string_view type) {
    const std::string plain = plainName(type);
    if (contains(plain, {"needle", "nadel", "conifer"})) return true;
    if (contains(plain, {"broad", "laub"})) return false;
    return std::nullopt;
}

}  // namespace

std::span<const TreeFieldName> listTreeFieldNames() { return listedTreeFields; }

std::span<const TreeRoleEntry> listTreeRoles() { return treeRoles; }

namespace {

// Shapefiles cut names after ten letters, accents counted twice.
bool isCutName(std::string_view name, std::string_view plain, std::string_view listed) {
    constexpr std::size_t cutLength = 10, minLetters = 8;
    return name.size() == cutLength && plain.size() >= minLetters && listed.starts_with(plain);
}

std::optional<std::size_t> findTreeField(std::span<const std::string> names,
                                         const std::vector<std::string>& plain, std::string_view listed) {
    for (std::size_t i = 0; i < plain.size(); ++i)
        if (plain[i] == listed) return i;
    for (std::size_t i = 0; i < plain.size(); ++i)
        if (isCutName(names[i], plain[i], listed)) return i;
    return std::nullopt;
}

bool isChosen(const TreeFieldChoices& choices, TreeRole role) {
    return std::ranges::find(choices, role, &TreeFieldChoice::role) != choices.end();
}

// The unit that is listed for a field of this name, where the user states none.
LengthUnit unitListedFor(const std::string& plain, const TreeFieldChoice& choice) {
    const auto alike = std::ranges::find_if(listedTreeFields, [&](const TreeFieldName& entry) {
        return entry.name == plain && entry.role == choice.role;
    });
    return choice.unit.value_or(alike == listedTreeFields.end() ? m : alike->unit);
}

}  // namespace

std::vector<KnownTreeField> findTreeFields(std::span<const std::string> names,
                                           const TreeFieldChoices& choices) {
    std::vector<std::string> plain;
    for (const std::string& name : names) plain.push_back(plainName(withoutAccents(name)));
    std::vector<KnownTreeField> known;
    for (const TreeFieldChoice& choice : choices)
        if (const auto at = std::ranges::find(names, choice.field); at != names.end()) {
            const auto index = std::size_t(at - names.begin());
            known.push_back({*at, index, {.role = choice.role, .unit = unitListedFor(plain[index], choice)}});
        }
    for (const TreeFieldName& entry : listedTreeFields) {
        if (isChosen(choices, entry.role) || findRole(known, entry.role) != nullptr) continue;
        if (!entry.besides.empty() && !isIn(plain, entry.besides)) continue;
        if (const auto index = findTreeField(names, plain, entry.name))
            known.push_back({names[*index], *index, entry});
    }
    return known;
}

Result<TreeFieldChoice> parseTreeFieldChoice(std::string_view text) {
    const auto equals = text.find('='), colon = text.rfind(':');
    const auto role = std::ranges::find(treeRoles, text.substr(0, equals), &TreeRoleEntry::key);
    if (equals == text.npos || role == treeRoles.end()) {
        std::vector<std::string_view> keys;
        for (const TreeRoleEntry& entry : treeRoles) keys.push_back(entry.key);
        return failure(
            "This states no field of trees", std::string(text),
            fmt::format("Give ROLE=FIELD or ROLE=FIELD:UNIT, where ROLE is {}", fmt::join(keys, ", ")));
    }
    TreeFieldChoice choice{role->role, std::string(text.substr(equals + 1))};
    if (colon == text.npos || colon < equals) return choice;
    const auto units = listLengthUnits();
    const auto unit = std::ranges::find(units, text.substr(colon + 1), &LengthUnitEntry::key);
    if (unit == units.end()) return choice;  // a field's name may have colons
    choice.field = std::string(text.substr(equals + 1, colon - equals - 1));
    choice.unit = unit->unit;
    return choice;
}

const KnownTreeField* findRole(std::span<const KnownTreeField> fields, TreeRole role) {
    const auto found =
        std::ranges::find_if(fields, [&](const KnownTreeField& field) { return field.meaning.role == role; });
    return found == fields.end() ? nullptr : &*found;
}

namespace {

// "6 – 10", "6 to 10" and "6 bis 10" as "6-10".
std::string withDash(std::string text) {
    for (const std::string_view word : {"\u2013", " to ", " bis "})
        if (const auto at = text.find(word); at != text.npos) text.replace(at, word.size(), "-");
    return text;
}

// "m" of "10 m".
std::string_view unitAtEnd(std::string_view text) {
    const auto last = text.find_last_of("0123456789.");
    return last == text.npos ? text : text.substr(last + 1);
}

// The middle of "6-10 m": both ends have the unit of the last.
std::optional<double> parseLengthClass(std::string_view text, LengthUnit bareUnit) {
    const auto dash = text.find('-', 1);
    if (dash == text.npos) return std::nullopt;
    std::string low(text.substr(0, text.find_last_not_of(' ', dash - 1) + 1));
    const std::string_view high = text.substr(dash + 1);
    if (unitAtEnd(low).empty()) low += unitAtEnd(high);
    const auto from = parseMetres(low, bareUnit), to = parseMetres(high, bareUnit);
    if (!from || !to || *from > *to) return std::nullopt;
    return (*from + *to) / 2;
}

}  // namespace

std::optional<double> parseTreeLength(std::string_view written, LengthUnit bareUnit) {
    const auto first = written.find_first_not_of(" <>=~");
    if (first == written.npos) return std::nullopt;
    const std::string text = withDecimalPoint(withDash(std::string(written.substr(first))));
    if (auto metres = parseMetres(text, bareUnit)) return metres;
    return parseLengthClass(text, bareUnit);
}

bool saysNoTree(std::span<const KnownTreeField> fields, std::span<const std::string> values) {
    constexpr std::array<std::string_view, 12> states{"dead",    "stump",    "shaft",    "removed",
                                                      "felled",  "vacant",   "emptypit", "empty",
                                                      "planned", "gefaellt", "abattu",   "retired"};
    constexpr std::array<std::string_view, 10> names{
        "stump",    "vacant", "potentialsite", "plantingsite", "plantingpending",
        "emptypit", "notree", "asphaltedwell", "shrub",        "privateshrub"};
    const auto begins = [&](TreeRole role, std::span<const std::string_view> words) {
        const KnownTreeField* field = findRole(fields, role);
        if (field == nullptr) return false;
        const std::string plain = plainName(withoutAccents(values[field->index]));
        return std::ranges::any_of(words, [&](std::string_view word) { return plain.starts_with(word); });
    };
    return begins(TreeRole::status, states) || begins(TreeRole::species, names);
}

TreeFacts collectTreeFacts(std::span<const KnownTreeField> fields, std::span<const std::string> written,
                           const std::string& where, Warnings& warnings) {
    TreeValues values(fields, written, where, warnings);
    TreeFacts facts{.sourceId = where, .species = nameSpecies(values)};
    facts.heightM = values.length(TreeRole::height, isPlausibleTreeHeight);
    facts.crownDiameterM = values.length(TreeRole::crownDiameter, isPlausibleCrown);
    facts.crownBaseM = values.length(TreeRole::crownBase, isPlausibleTreeHeight);
    facts.stemDiameterM = values.length(TreeRole::stemDiameter, isPlausibleStem);
    if (!facts.stemDiameterM)
        facts.stemDiameterM = values.length(TreeRole::stemGirth, isPlausibleStem, 1 / std::numbers::pi);
    if (!facts.heightM && !facts.crownDiameterM && !facts.stemDiameterM) values.notePlanting();
    facts.evergreen = readEvergreen(values.text(TreeRole::leafCycle));
    facts.needles = readNeedles(values.text(TreeRole::leafType));
    facts.leafOnDay = values.day(TreeRole::leafOnDay);
    facts.leafOffDay = values.day(TreeRole::leafOffDay);
    return facts;
}

}  // namespace noonmark
