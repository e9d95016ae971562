#include "core/io/heights/name_words.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <unordered_map>

#include "core/io/files/readable_text.h"

namespace noonmark {

namespace {

struct Vocabulary {
    NameWord meaning;
    std::string_view words;  // folded, separated by blanks
};

// In English, German, French, Spanish, Portuguese, Catalan, Italian, Dutch, Danish, Norwegian, Swedish,
// Finnish, Estonian, Polish, Czech, Slovak, Slovene, Croatian, Hungarian, Romanian, Turkish, Greek, Russian,
// Ukrainian, Japanese, Chinese, Korean, Vietnamese and Indonesian, with the abbreviations of published
// tables.
constexpr std::array vocabularies{
    Vocabulary{NameWord::height,
               "height heights hgt hgts hght ht heigth hoehe hoehen hohe hohen hauteur hauteurs haut altura "
               "alturas alcada altezza altezze hoogte hoogtes hojd hojder hojde hoejd hoejde hoyde hoyder "
               "korkeus korgus wysokosc wys vyska vysky visina viska magassag inaltime yukseklik υψοσ высота "
               "висота 高さ 高度 高 height 높이 樓高 楼高 tinggi ketinggian chieucao cao"},
    Vocabulary{
        NameWord::storey,
        "storey storeys story stories floor floors flr flrs levels etage etages etager etasje etasjer "
        "etaj etaje geschoss geschosse geschosszahl stockwerk stockwerke vollgeschosse piso pisos plantas "
        "plantes piani piano andares pavimentos bouwlagen bouwlaag verdieping verdiepingen vaning "
        "vaningar kerros kerrosta kerrosluku kondygnacja kondygnacje kondygnacji podlazi podlazia patra "
        "nadlazi poschodi korrus korruseid etaza etaze katovi emelet emeletek szintek szint kat katlar "
        "οροφοι οροφοσ οροφων этаж этажа этажи этажей этажность поверх поверхи поверхів 階 階数 層 層数 層數 "
        "层 层数 "
        "楼层 樓層 층 층수 lantai tang sotang"},
    Vocabulary{
        NameWord::count,
        "n no nr nb nbr num number numbers numero nombre count cnt total tot anzahl anz zahl cantidad cant "
        "quantidade antal antall aantal liczba pocet broj stevilo numar sayisi sayi lukumaara arv "
        "αριθμοσ so количество число кількість 数 數 수"},
    Vocabulary{
        NameWord::building,
        "building buildings bldg bldgs bld blds bldng bldngs blg blgs build footprint footprints ftprints "
        "house houses roofprint roofprints rooftops structures gebaeude gebaude geb gebs haus haeuser bauten "
        "hauser bauwerke batiment batiments bati bat constructions edificio edificios edificacao "
        "edificacoes edificacion edificaciones edifici edificis fabbricato fabbricati budova budovy "
        "budynek budynki byggnad byggnader bygning bygninger rakennus rakennukset hoone hooned ehitis "
        "epulet epuletek zgrada zgrade stavba stavby cladire cladiri bina binalar pand panden gebouw "
        "gebouwen κτιριο κτιριου κτιρια κτηριο κτηριου κτηρια здание здания строение строения будівля "
        "будівлі 建物 建築物 建筑 "
        "建筑物 건물 건축물 gedung bangunan toanha"},
    Vocabulary{NameWord::roof,
               "roof roofs rooftop dach dachs toit toiture techo tejado cubierta telhado tetto copertura dak "
               "daken tak katto katus krov streha strecha acoperis cati крыша дах 屋根 屋顶 屋頂 지붕 atap"},
    Vocabulary{NameWord::eaves, "eave eaves gutter traufe gouttiere gronda alero goot okap"},
    Vocabulary{NameWord::ground,
               "ground gnd grnd terrain gelaende gelande boden sol suelo terreno maaiveld mark maapind teren "
               "земля 地盤 地面 지반 tanah"},
    Vocabulary{NameWord::terrainModel, "dgm dtm mnt mdt"},
    Vocabulary{
        NameWord::elevation,
        "absolute abs elevation elev nn nhn nap msl amsl asl sealevel sea absolut absolu absolue absoluta "
        "absolut altitude altitud cota quota 標高 海拔 해발 표고"},
    Vocabulary{NameWord::above,
               "above aboveground agl over ueber uber relative rel oberirdisch oberirdische oberirdischen "
               "sobre rasante "
               "nadzemni nadzemnich nadzemne nadziemne nadziemnych надземных 地上 지상"},
    Vocabulary{NameWord::below,
               "below belowground under underground basement basements bsmt cellar cellars unterirdisch "
               "unterirdische unterirdischen keller sotano sotanos subterraneos bajo interrati interrato "
               "sottosuolo kaelder kellari podzemni podzemnich podziemne podziemnych подземных 地下 지하"},
    Vocabulary{
        NameWord::typical,
        "mean median med avg average mittel mittlere mittl moyenne moyen moy media medio mediana promedio "
        "gemiddelde gjennomsnitt srednia prumer keskmine среднее 平均 평균"},
    Vocabulary{
        NameWord::greatest,
        "max maximum highest tallest ridge top maximale maximal maxima maximo massima massimo maks najwyzsza "
        "максимальная 最大 最高 최고 최대"},
    Vocabulary{NameWord::minimum, "min minimum lowest minimale minimal minima minimo minim 最小 最低 최저"},
    Vocabulary{NameWord::feet, "ft feet foot pies"},
    Vocabulary{NameWord::usSurveyFeet, "usft"},
    Vocabulary{NameWord::metres,
               "m mtr mtrs meter meters metre metres metros metri metrow metru metry 米 미터 метр метров"},
    Vocabulary{NameWord::centimetres, "cm centimetre centimetres centimeter centimeters 厘米"},
    Vocabulary{NameWord::decimetres, "dm decimetre decimetres decimeter decimeters"},
    Vocabulary{NameWord::millimetres, "mm millimetre millimetres millimeter millimeters"},
    Vocabulary{NameWord::inches, "inch inches"},
    Vocabulary{
        NameWord::filler,
        "of in the to de des du da do del dei degli della der die das le la les el los and e et y d l "
        "chieu value val est estimated calc calculated measured gemessen gemessene mesuree medida misurata"},
    Vocabulary{
        NameWord::otherThing,
        "id fid oid gid objectid uid uuid code kod cod year date datum area areal surface shape length "
        "perimeter leng lat lon latitude longitude x y zip volume vol angle prinx member yearbuilt annee "
        "anno ano jahr rok flaeche umfang superficie version confidence precision prec accuracy acqu qualite "
        "quality error rmse std stddev sigma addr address adr postcode postal plz cp zipcode lod plani "
        "insee phone tel population pop units dwellings logements logts "
        "rooms beds far gfa slope azimuth "
        "orientation rotation rank class type typ category status usage use source width breite depth "
        "tiefe age reject valid pw snapping layer mat material materials materiau materiaux materialien 面積 "
        "用途 "
        "番号 編號 编号 면적"},
    Vocabulary{
        NameWord::otherLayer,
        "plot plots parcel parcels parcelle parcelles lot lots flurstueck flurstuecke tessellation "
        "tessellations enclosure enclosures cell cells block blocks zone zones zoning district districts "
        "boundary boundaries border borders limit limits municipality municipalities county counties "
        "parish parishes state states country countries neighbourhood neighbourhoods neighborhood "
        "neighborhoods quarter quarters suburb suburbs region regions place places census tract tracts "
        "ward wards admin administrative landuse land cover landcover water waterbody waterbodies lake "
        "lakes river rivers sea canal park parks green greens garden gardens forest forests wood woods "
        "vegetation tree trees canopy meadow farmland natural nature road roads street streets "
        "path paths highway highways railway railways rail pavement pavements sidewalk sidewalks kerb "
        "parking parkings driveway bridge bridges grid tiles tile index frame mask study sites site area "
        "areas extent bbox cimetiere reservoir aerodrome terrain relief contour contours isochrones "
        "parcelas parcela manzanas manzana barrios barrio calles zonas gemeinden gemeinde strassen "
        "gewaesser wege parzellen parzelle kvartal percelen perceel straten wijken buurten wegdeel "
        "vassen bebauungsplan bebauungsplaene bebauungsplane bplan zonenplan parcely parcela ulice dzialki "
        "dzialka teiler soil surface surfaces"},
};

using WordTable = std::unordered_map<std::string_view, NameWord>;

// A word of two lists has the first of its meanings.
WordTable makeTable() {
    WordTable table;
    for (const Vocabulary& one : vocabularies)
        for (std::string_view rest = one.words; !rest.empty();) {
            const std::size_t end = std::min(rest.find(' '), rest.size());
            table.try_emplace(rest.substr(0, end), one.meaning);
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
    return table;
}

// Letters of U+0100 to U+017F without their marks.
constexpr std::string_view latinExtendedA =
    "aaaaaaccccccccddddeeeeeeeeeegggggggghhhhiiiiiiiiiiiijjkkkllllllllllnnnnnnnnnoooooooorrrrrrsssssssstttttt"
    "uuuuuuuuuuuuwwyyyzzzzzzs";
// Of U+00C0 to U+00D6 and U+00E0 to U+00F6; withoutMark() has the others.
constexpr std::string_view latin1 = "aaaaaaaceeeeiiiidnooooo";

// Of Romanian (with a comma below) and Vietnamese.
struct LatinLetters {
    char32_t first, last;
    std::string_view plain;
};
constexpr std::array otherLatin{LatinLetters{0x1A0, 0x1A1, "o"},   LatinLetters{0x1AF, 0x1B0, "u"},
                                LatinLetters{0x218, 0x219, "s"},   LatinLetters{0x21A, 0x21B, "t"},
                                LatinLetters{0x1EA0, 0x1EB7, "a"}, LatinLetters{0x1EB8, 0x1EC7, "e"},
                                LatinLetters{0x1EC8, 0x1ECB, "i"}, LatinLetters{0x1ECC, 0x1EE3, "o"},
                                LatinLetters{0x1EE4, 0x1EF1, "u"}, LatinLetters{0x1EF2, 0x1EF9, "y"}};

std::string_view withoutMark(char32_t point) {
    if (point == 0xC6 || point == 0xE6) return "ae";
    if (point == 0xDF) return "ss";
    if (point == 0xDE || point == 0xFE) return "th";
    if (point == 0xD8 || point == 0xF8) return "o";
    if (point >= 0xD9 && point <= 0xDC) return "u";
    if (point >= 0xF9 && point <= 0xFC) return "u";
    if (point == 0xDD || point == 0xFD || point == 0xFF) return "y";
    if (point >= 0xC0 && point <= 0xF6) return latin1.substr((point - 0xC0) % 0x20, 1);
    if (point >= 0x100 && point < 0x100 + latinExtendedA.size())
        return latinExtendedA.substr(point - 0x100, 1);
    for (const LatinLetters& some : otherLatin)
        if (point >= some.first && point <= some.last) return some.plain;
    return {};
}

struct GreekLetter {
    char32_t marked, plain;
};
constexpr std::array greekLetters{
    GreekLetter{0x386, 0x3B1}, GreekLetter{0x388, 0x3B5}, GreekLetter{0x389, 0x3B7},
    GreekLetter{0x38A, 0x3B9}, GreekLetter{0x38C, 0x3BF}, GreekLetter{0x38E, 0x3C5},
    GreekLetter{0x38F, 0x3C9}, GreekLetter{0x3AC, 0x3B1}, GreekLetter{0x3AD, 0x3B5},
    GreekLetter{0x3AE, 0x3B7}, GreekLetter{0x3AF, 0x3B9}, GreekLetter{0x3CC, 0x3BF},
    GreekLetter{0x3CD, 0x3C5}, GreekLetter{0x3CE, 0x3C9}, GreekLetter{0x3C2, 0x3C3}};

char32_t smallLetter(char32_t point) {
    if (point >= 0x410 && point <= 0x42F) return point + 0x20;  // Cyrillic
    if (point >= 0x400 && point <= 0x40F) return point + 0x50;
    if (point >= 0x391 && point <= 0x3A9) return point + 0x20;  // Greek
    for (const GreekLetter& letter : greekLetters)
        if (letter.marked == point) return letter.plain;
    return point;
}

bool isCapitalAscii(char32_t point) { return point >= 'A' && point <= 'Z'; }
bool isSmallAscii(char32_t point) { return point >= 'a' && point <= 'z'; }
bool isDigitAscii(char32_t point) { return point >= '0' && point <= '9'; }

char32_t narrow(char32_t point) { return point >= 0xFF01 && point <= 0xFF5E ? point - 0xFEE0 : point; }

bool isLetterPoint(char32_t point) {
    if (point < 0x80) return isCapitalAscii(point) || isSmallAscii(point);
    const bool mark = point < 0xC0 || point == 0xD7 || point == 0xF7;
    const bool punctuation = (point >= 0x2000 && point < 0x2E80) || (point >= 0x3000 && point < 0x3040);
    return !mark && !punctuation && point != 0xFFFD;
}

void appendFolded(std::string& text, char32_t point) {
    if (isCapitalAscii(point)) point = point - 'A' + 'a';
    const std::string_view plain = withoutMark(point);
    if (!plain.empty())
        text += plain;
    else
        appendUtf8(text, smallLetter(point));
}

// An accent of its own behind its letter, as some systems write names.
bool isCombiningMark(char32_t point) { return point >= 0x300 && point < 0x370; }

std::vector<char32_t> pointsOfName(std::string_view name) {
    std::vector<char32_t> points;
    for (std::size_t at = 0; at < name.size();)
        if (const char32_t point = narrow(nextCodePoint(name, at)); !isCombiningMark(point))
            points.push_back(point);
    return points;
}

// "buildingHeight", "BLDGHeight": before the capital that begins a word.
bool beginsWord(const std::vector<char32_t>& points, std::size_t i) {
    if (i == 0 || !isCapitalAscii(points[i])) return false;
    const bool nextIsSmall = i + 1 < points.size() && isSmallAscii(points[i + 1]);
    return isSmallAscii(points[i - 1]) || (isCapitalAscii(points[i - 1]) && nextIsSmall);
}

// Shorter words are found in a word written together only where they are units or fillers after another.
bool mayBePiece(std::string_view word, std::size_t at) {
    if (word.size() >= 3) return true;
    return at > 0 &&
           (word == "in" || word == "ft" || word == "cm" || word == "dm" || word == "mm" || word == "ht");
}

// The fewest known words that make up `word`; none if there are no such words.
std::vector<std::string> splitWord(const std::string& word) {
    constexpr std::size_t longest = 48, none = 1000;
    if (word.size() > longest) return {};
    std::vector<std::size_t> count(word.size() + 1, none), from(word.size() + 1, 0);
    count[0] = 0;
    for (std::size_t at = 0; at < word.size(); ++at)
        for (std::size_t end = at + 1; count[at] < none && end <= word.size(); ++end) {
            const std::string_view piece = std::string_view(word).substr(at, end - at);
            if (count[at] + 1 >= count[end] || !mayBePiece(piece, at) || !findNameWord(piece)) continue;
            count[end] = count[at] + 1;
            from[end] = at;
        }
    std::vector<std::string> words;
    for (std::size_t end = word.size(); count[word.size()] < none && end > 0; end = from[end])
        words.insert(words.begin(), word.substr(from[end], end - from[end]));
    return words;
}

}  // namespace

std::optional<NameWord> findNameWord(std::string_view word) {
    static const WordTable table = makeTable();
    const auto found = table.find(word);
    return found == table.end() ? std::nullopt : std::optional(found->second);
}

std::string foldName(std::string_view name) {
    std::string text;
    for (const char32_t point : pointsOfName(name)) {
        if (isDigitAscii(point)) text += char(point);
        if (isLetterPoint(point)) appendFolded(text, point);
    }
    return text;
}

std::vector<std::string> wordsOfName(std::string_view name) {
    std::vector<std::string> whole{""};
    const std::vector<char32_t> points = pointsOfName(name);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool letter = isLetterPoint(points[i]);
        if ((!letter || beginsWord(points, i)) && !whole.back().empty()) whole.emplace_back();
        if (letter) appendFolded(whole.back(), points[i]);
    }
    if (whole.back().empty()) whole.pop_back();
    std::vector<std::string> words;
    for (std::string& word : whole) {
        const auto pieces = findNameWord(word) ? std::vector<std::string>() : splitWord(word);
        if (pieces.empty())
            words.push_back(std::move(word));
        else
            words.insert(words.end(), pieces.begin(), pieces.end());
    }
    return words;
}

NameWords::NameWords(std::string_view name) {
    const std::vector<std::string> words = wordsOfName(name);
    endsInIn_ = words.size() > 1 && words.back() == "in";
    for (const std::string& word : words) {
        const auto meaning = findNameWord(word);
        if (meaning)
            known_.push_back(*meaning);
        else
            ++unknown_;
    }
}

bool NameWords::has(NameWord word) const { return std::ranges::find(known_, word) != known_.end(); }

}  // namespace noonmark
