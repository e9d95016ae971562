#include "core/io/heights/tree_fields.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <numbers>

#include "core/io/heights/height_text.h"

namespace noonmark {

namespace {

constexpr auto cm = LengthUnit::centimetres, in = LengthUnit::inches, ft = LengthUnit::feet,
               m = LengthUnit::metres;

// Vienna's classes, from the description of its register of trees: 0 is unknown.
constexpr std::array viennaHeights{0.0, 2.5, 8.0, 13.0, 18.0, 23.0, 28.0, 33.0, 37.0};
constexpr std::array viennaCrowns{0.0, 1.5, 5.0, 8.0, 11.0, 14.0, 17.0, 20.0, 23.0};

// Sources: the descriptions of the inventories that the comments name.
constexpr std::array listedTreeFields{
    TreeFieldName{"baumhoehe", TreeRole::height, m, "stammumfang", viennaHeights},
    TreeFieldName{"baumhoehe", TreeRole::height, m},    // Berlin
    TreeFieldName{"treeheight", TreeRole::height, ft},  // Seattle
    TreeFieldName{"hauteurenm", TreeRole::height, m},   // Paris
    TreeFieldName{"hauteur", TreeRole::height, m},
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
    TreeFieldName{"kronendurchmesser", TreeRole::crownDiameter, m, "stammumfang", viennaCrowns},
    TreeFieldName{"kronendurchmesser", TreeRole::crownDiameter, m},  // Zurich
    TreeFieldName{"kronedurch", TreeRole::crownDiameter, m},         // Berlin
    TreeFieldName{"diametercrown", TreeRole::crownDiameter, m},      // OpenStreetMap
    TreeFieldName{"crowndiameter", TreeRole::crownDiameter, m},
    TreeFieldName{"crowndiam", TreeRole::crownDiameter, m},
    TreeFieldName{"crownwidth", TreeRole::crownDiameter, m},
    TreeFieldName{"crownspread", TreeRole::crownDiameter, m},
    TreeFieldName{"crownm", TreeRole::crownDiameter, m},
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
    TreeFieldName{"stammumfang", TreeRole::stemGirth, cm},        // Vienna
    TreeFieldName{"stammumfg", TreeRole::stemGirth, cm},          // Berlin
    TreeFieldName{"circumference", TreeRole::stemGirth, m},       // OpenStreetMap
    TreeFieldName{"genus", TreeRole::genus},
    TreeFieldName{"genre", TreeRole::genus},  // Paris
    TreeFieldName{"gattung", TreeRole::genus},
    TreeFieldName{"baumgattunglat", TreeRole::genus},  // Zurich
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
    TreeFieldName{"latinname", TreeRole::species},
    TreeFieldName{"taxon", TreeRole::species},
    TreeFieldName{"species", TreeRole::species},
    TreeFieldName{"leafcycle", TreeRole::leafCycle},   // OpenStreetMap
    TreeFieldName{"leaftype", TreeRole::leafType},     // OpenStreetMap
    TreeFieldName{"baumtyptext", TreeRole::leafType},  // Zurich
    TreeFieldName{"baumtyp", TreeRole::leafType},
    TreeFieldName{"longitude", TreeRole::longitude},
    TreeFieldName{"lon", TreeRole::longitude},
    TreeFieldName{"lng", TreeRole::longitude},
    TreeFieldName{"latitude", TreeRole::latitude},
    TreeFieldName{"lat", TreeRole::latitude},
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
        const auto metres = read(*field->meaning, written);
        if (metres && *metres == 0) return std::nullopt;
        if (metres && plausible(*metres * factor)) return *metres * factor;
        warnings_.push_back(
            {WarningKind::leftOut,
             metres ? "a measure of a tree that no tree has" : "a measure of a tree that is no number",
             where_ + ": " + field->field + " " + std::string(written)});
        return std::nullopt;
    }

private:
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

// "Platanus x hispanica :: London plane": the Latin name comes first.
std::string nameSpecies(const TreeValues& values) {
    std::string_view whole = values.text(TreeRole::species);
    whole = whole.substr(0, whole.find("::"));
    while (!whole.empty() && whole.back() == ' ') whole.remove_suffix(1);
    const std::string_view genus = values.text(TreeRole::genus), epithet = values.text(TreeRole::epithet);
    if (genus.empty()) return std::string(whole);
    if (whole.starts_with(genus)) return std::string(whole);
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

std::vector<KnownTreeField> findTreeFields(std::span<const std::string> names) {
    std::vector<std::string> plain;
    for (const std::string& name : names) plain.push_back(plainName(withoutAccents(name)));
    std::vector<KnownTreeField> known;
    for (const TreeFieldName& entry : listedTreeFields) {
        if (findRole(known, entry.role) != nullptr) continue;
        if (!entry.besides.empty() && !isIn(plain, entry.besides)) continue;
        const auto found = std::ranges::find(plain, entry.name);
        if (found == plain.end()) continue;
        const auto index = std::size_t(found - plain.begin());
        known.push_back({names[index], index, &entry});
    }
    return known;
}

const KnownTreeField* findRole(std::span<const KnownTreeField> fields, TreeRole role) {
    const auto found = std::ranges::find_if(
        fields, [&](const KnownTreeField& field) { return field.meaning->role == role; });
    return found == fields.end() ? nullptr : &*found;
}

std::optional<double> parseTreeLength(std::string_view text, LengthUnit bareUnit) {
    const auto first = text.find_first_not_of(" <>=~");
    if (first == text.npos) return std::nullopt;
    text.remove_prefix(first);
    if (auto metres = parseMetres(text, bareUnit)) return metres;
    const auto dash = text.find('-', 1);
    if (dash == text.npos) return std::nullopt;
    const auto high = parseTreeLength(text.substr(dash + 1), bareUnit);
    const auto low = parseMetres(text.substr(0, text.find_last_not_of(' ', dash - 1) + 1), bareUnit);
    if (!low || !high || *low > *high) return std::nullopt;
    return (*low + *high) / 2;
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
    facts.evergreen = readEvergreen(values.text(TreeRole::leafCycle));
    facts.needles = readNeedles(values.text(TreeRole::leafType));
    return facts;
}

}  // namespace noonmark
