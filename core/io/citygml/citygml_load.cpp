#include "core/io/citygml/citygml_load.h"

#include <fmt/format.h>
#include <algorithm>
#include <iterator>
#include <map>
#include <unordered_set>
#include <utility>

#include "core/base/safe_text.h"
#include "core/io/citygml/gml_object.h"
#include "core/io/cityjson/cityjson_load.h"
#include "core/io/files/xml_stream.h"
#include "core/io/heights/tree_fields.h"
#include "core/io/pieces/read_part.h"

namespace noonmark {

namespace {

constexpr std::size_t maxCorners = 40'000'000;
constexpr std::size_t mostShared = 200'000;  // ids that objects take from others

bool isBlankText(std::string_view text) { return text.find_first_not_of(" \t\r\n") == text.npos; }

/// Puts the objects of a file together, element by element.
class CityGmlListener final : public XmlListener {
public:
    CityGmlListener(std::string file, const ReadSettings& settings, LodChoice choice, GmlContent wanted)
        : file_(std::move(file)), values_(settings), choice_(choice), wanted_(wanted), settings_(settings) {}
    CityGmlData data;
    std::unordered_set<std::string> wantedIds;  ///< that an object refers to and another one may have
    GmlShared shared;                           ///< what has these ids

    bool isCollecting = false;  ///< nothing is kept but what has the ids in `wantedIds`

    Result<void> begin(const XmlElement& element) override {
        if (skipped_ > 0) return void(++skipped_), Result<void>();
        learnReference(element);
        if (raster_) return void(++rasterDepth_), Result<void>();
        if (isInGeometry_) return reader_.begin(element);
        names_.emplace_back(element.name);
        if (names_.size() == 1) return checkRoot(element);
        if (objects_.empty())
            beginOutside(element);
        else
            beginInside(element);
        return {};
    }

    Result<void> end(std::string_view name, std::string_view text) override {
        if (skipped_ > 0) return void(--skipped_), Result<void>();
        if (raster_ && rasterDepth_ > 0) {
            --rasterDepth_;
            raster_->end(name, trimmed(text));
            return {};
        }
        if (isInGeometry_ && !reader_.isAtProperty()) return reader_.end(name, text);
        if (isInGeometry_)
            endGeometry();
        else if (raster_)
            endRaster();
        else if (objects_.empty())
            endOutside(name, text);
        else
            endAttribute(name, trimmed(text));
        names_.pop_back();
        if (names_.size() < boundaryDepth_) boundaryDepth_ = 0;
        if (names_.size() < openingDepth_) openingDepth_ = 0;
        return !open_.empty() && names_.size() < open_.back().depth ? endObject() : Result<void>();
    }

    [[nodiscard]] bool wantsText() const override {
        return skipped_ == 0 && (isInGeometry_ ? reader_.wantsText() : true);
    }

    void warnOfInterior() {
        for (const auto& [name, count] : asides_)
            data.city.warnings.push_back({WarningKind::leftOut, "what is inside of buildings shades nothing",
                                          fmt::format("{}: {} ({})", file_, name, count)});
    }

private:
    struct OpenObject {
        std::size_t index, depth;  // in objects_, of its element
    };

    Result<void> checkRoot(const XmlElement& element) {
        if (element.name != "CityModel" && element.name != "FeatureCollection")
            return failure(fmt::format("This is not CityGML: it begins with <{}>", element.name), {},
                           "Choose a file that begins with <CityModel>");
        for (const char* const* at = element.attributes; *at != nullptr; at += 2)
            for (const char* version : {"1.0", "2.0", "3.0"})
                if (std::string_view(at[1]) == std::string("http://www.opengis.net/citygml/") + version)
                    data.city.version = version;
        return {};
    }

    void learnReference(const XmlElement& element) {
        const std::string_view stated = element.attribute("srsName");
        if (stated.empty() || stated == data.city.crs || stated == otherReference_) return;
        if (data.city.crs.empty()) {
            data.city.crs = stated;
            areDegrees_ = isGeographicReference(data.city.crs);
            return;
        }
        otherReference_ = stated;
        warn(WarningKind::assumed, "a second reference system is stated; the first is used",
             std::string(stated));
    }

    void beginOutside(const XmlElement& element) {
        if (isGmlAside(element.name)) return skip();
        if (!isGmlMember(names_[names_.size() - 2])) return;
        const GmlObjectKind kind = findGmlObjectKind(element.name);
        if (kind == GmlObjectKind::container) return;
        if (kind != GmlObjectKind::other) return beginObject(element);
        ++data.city.features;
        if (element.name == "RasterRelief" && !isCollecting && wanted_ == GmlContent::buildings) {
            raster_.emplace();
            rasterDepth_ = 0;
            rasterId_ = element.attribute("id");
            return;
        }
        warn(WarningKind::leftOut, fmt::format("not a building but {}", element.name),
             std::string(element.attribute("id")));
        skip();
    }

    void beginInside(const XmlElement& element) {
        unit_ = element.attribute("uom");
        if (const auto name = element.attribute("name"); !name.empty()) genericName_ = name;
        if (isGmlAside(element.name)) return skipAside(element.name);
        if (findGmlObjectKind(element.name) == GmlObjectKind::building) return beginObject(element);
        if (boundaryDepth_ == 0 && isGmlBoundary(element.name)) boundaryDepth_ = names_.size();
        if (boundaryDepth_ > 0 && isGmlOpening(element.name)) {
            openingDepth_ = names_.size();
            opening_ = {std::string(element.attribute("id")), element.name.starts_with("Window"), 0, {}};
        }
        if (const auto property = findLodProperty(element.name)) {
            property_ = *property;
            isInGeometry_ = true;
            reader_.open(element);
        }
    }

    void beginObject(const XmlElement& element) {
        ++data.city.features;
        GmlObject object;
        object.object.type = element.name;
        object.object.id = freeId(element);
        if (!open_.empty()) object.object.parent = objects_[open_.back().index].object.id;
        open_.push_back({objects_.size(), names_.size()});
        objects_.push_back(std::move(object));
    }

    // Objects without an id, and two with the same, must be told apart.
    std::string freeId(const XmlElement& element) {
        std::string id(element.attribute("id"));
        if (id.empty()) id = fmt::format("{} {}", element.name, data.city.features);
        std::string free = id;
        for (int number = 2; !ids_.insert(free).second; ++number) free = fmt::format("{} ({})", id, number);
        return free;
    }

    void endRaster() {
        const std::string fault = raster_->findFault();
        if (fault.empty())
            data.city.blocks.push_back(raster_->makeBlock(rasterId_));
        else
            warn(WarningKind::leftOut,
                 "a terrain that is a raster (RasterRelief): name it as a GeoTIFF beside this file",
                 rasterId_ + ", " + fault);
        raster_.reset();
    }

    void skip() {
        names_.pop_back();
        skipped_ = 1;
    }

    void skipAside(std::string_view name) {
        if (name.starts_with("interior") || name.starts_with("building")) ++asides_[std::string(name)];
        skip();
    }

    GmlObject& object() { return objects_[open_.back().index]; }

    void endGeometry() {
        isInGeometry_ = false;
        GmlGeometry geometry = reader_.close();
        if (wanted_ == GmlContent::openings && openingDepth_ > 0) {
            opening_.lod = property_.lod;
            opening_.geometry = geometry;
            object().openings.push_back(opening_);
        }
        object().add(property_, owner(), std::move(geometry));
    }

    [[nodiscard]] GmlObject::Owner owner() const {
        if (boundaryDepth_ == 0) return GmlObject::Owner::object;
        return openingDepth_ > 0 ? GmlObject::Owner::opening : GmlObject::Owner::surface;
    }

    void endOutside(std::string_view name, std::string_view text) {
        const bool ofModel = names_.size() == 4;  // CityModel, boundedBy, Envelope, lowerCorner
        if (!ofModel || (name != "lowerCorner" && name != "upperCorner")) return;
        std::vector<double> numbers;
        if (!readGmlNumbers(text, numbers) || numbers.size() < 2) return;
        const glm::dvec3 corner{numbers[0], numbers[1], numbers.size() > 2 ? numbers[2] : 0};
        if (name == "lowerCorner")
            lowerCorner_ = corner;
        else if (lowerCorner_)
            data.envelope = {*lowerCorner_, corner};
    }

    void endAttribute(std::string_view name, std::string_view text) {
        const std::string parent = names_.size() > 1 ? names_[names_.size() - 2] : std::string();
        if (isBlankText(text) || boundaryDepth_ > 0 || open_.back().depth == names_.size()) return;
        if (name == "name" && open_.back().depth + 1 == names_.size())
            object().object.name = text;
        else if (name == "name")
            genericName_ = text;
        else if (name != "value")
            object().add(std::string(name), text, unit_);
        else if (parent == "Height")  // of CityGML 3.0
            object().add("measuredHeight", text, unit_);
        else if (!genericName_.empty())
            object().add(genericName_, text, unit_);
    }

    Result<void> endObject() {
        open_.pop_back();
        if (!open_.empty()) return {};
        if (isCollecting) {
            reader_.share(wantedIds, shared);
            forgetObject();
            return {};
        }
        reader_.adopt(shared);
        for (std::string& id : reader_.unresolved())
            if (wantedIds.size() < mostShared) wantedIds.insert(std::move(id));
        if (findGmlObjectKind(objects_.front().object.type) == GmlObjectKind::plants) return addPlants();
        for (GmlObject& one : objects_) values_.add(one.attributes, one.object, data.city);
        for (const GmlObject& one : objects_)
            std::ranges::move(findOpenings(one, reader_), std::back_inserter(data.openings));
        const std::string id = objects_.front().object.id;
        CityJsonBlock block = makeBlock(objects_, reader_, choice_, areDegrees_, file_, data.city.warnings);
        if (!isInExtent(block)) {
            ++data.outsideExtent;
            forgetObject();
            return {};
        }
        corners_ += block.vertices.size();
        if (corners_ > maxCorners)
            return limitReached(fmt::format("The file has more than {} corners", maxCorners), id,
                                "Divide it");
        data.city.blocks.push_back(std::move(block));
        warnOf(id);
        forgetObject();
        return {};
    }

    // A tree whose shape is in another file stands at its reference point.
    Result<void> addPlants() {
        const std::string id = objects_.front().object.id;
        const TreeFacts facts = factsOf(objects_.front());
        CityJsonBlock block = makeBlock(objects_, reader_, choice_, areDegrees_, file_, data.city.warnings);
        CityJsonTree plants = makePlantCover(block.objects.front(), facts);
        if (block.objects.front().type != "PlantCover") plants.cover.clear();
        if (plants.vertices.empty() && !reader_.offsets().empty()) {
            plants.vertices.push_back(block.vertices.size());
            block.vertices.push_back(reader_.offsets().front().at);
        }
        block.objects.clear();
        if (plants.vertices.empty())
            warn(WarningKind::leftOut, "a tree without a place", id);
        else if (!isInExtent(block))
            ++data.outsideExtent;
        else {
            block.trees.push_back(std::move(plants));
            corners_ += block.vertices.size();
            data.city.blocks.push_back(std::move(block));
        }
        warnOf(id);
        forgetObject();
        return {};
    }

    TreeFacts factsOf(const GmlObject& object) {
        std::vector<std::string> names, values;
        for (const ObjectAttribute& attribute : object.attributes) {
            const bool isInFeet = attribute.unit == LengthUnit::feet;
            names.push_back(attribute.name);
            values.push_back(attribute.text + (isInFeet                                    ? " ft"
                                               : attribute.unit == LengthUnit::centimetres ? " cm"
                                                                                           : ""));
        }
        return collectTreeFacts(findTreeFields(names), values, file_ + ": " + object.object.id,
                                data.city.warnings);
    }

    bool isInExtent(const CityJsonBlock& block) {
        if (!settings_.extent || wanted_ == GmlContent::openings ||
            findGmlObjectKind(block.objects.empty() ? "" : block.objects.front().type) ==
                GmlObjectKind::terrain)
            return true;
        if (!extent_) extent_.emplace(settings_, data.city.crs);
        return extent_->mayTouch(block.vertices);
    }

    void forgetObject() {
        objects_.clear();
        reader_.clear();
        ids_.clear();
        genericName_.clear();
    }

    void warnOf(const std::string& id) {
        const auto say = [&](WarningKind kind, const char* what, std::size_t count) {
            if (count > 0) warn(kind, what, fmt::format("{} ({})", id, count));
        };
        say(WarningKind::dropped, "outlines with fewer than three corners or without numbers",
            reader_.brokenRings);
        say(WarningKind::assumed, "outlines without heights; they were taken at elevation 0",
            reader_.flatOutlines);
        say(WarningKind::leftOut, "shapes in other files, which are not opened", reader_.foreignShapes);
    }

    void warn(WarningKind kind, std::string what, const std::string& where) {
        data.city.warnings.push_back({kind, std::move(what), file_ + ": " + where});
    }

    std::string file_;
    ObjectValues values_;
    LodChoice choice_;
    GmlContent wanted_;
    const ReadSettings& settings_;
    std::optional<GmlExtent> extent_;
    GmlGeometryReader reader_;
    std::vector<std::string> names_;  // of the open elements but those of geometries
    std::size_t skipped_ = 0;         // depth below what is left out
    std::vector<GmlObject> objects_;  // of the open top-level object
    std::vector<OpenObject> open_;
    std::unordered_set<std::string> ids_;  // of the open top-level object
    std::size_t boundaryDepth_ = 0, openingDepth_ = 0, corners_ = 0;
    GmlObject::Opening opening_;
    bool isInGeometry_ = false, areDegrees_ = false;
    LodProperty property_;
    std::optional<GmlRasterReader> raster_;  // of the open RasterRelief
    std::size_t rasterDepth_ = 0;            // of elements below it
    std::string rasterId_;
    std::string unit_, genericName_, otherReference_;
    std::optional<glm::dvec3> lowerCorner_;
    std::map<std::string, std::size_t> asides_;
};

}  // namespace

Result<CityGmlData> loadCityGml(const std::filesystem::path& file, const ReadSettings& settings,
                                Progress& progress, const std::stop_token& stop, GmlContent wanted) {
    const Result<LodChoice> choice = parseLodChoice(settings.lod);
    if (!choice) return tl::make_unexpected(choice.error());
    std::optional<CityGmlListener> listener;
    const auto read = [&](bool collects, std::unordered_set<std::string> wantedIds, GmlShared shared) {
        listener.emplace(file.filename().string(), settings, *choice, wanted);
        listener->isCollecting = collects;
        listener->wantedIds = std::move(wantedIds);
        listener->shared = std::move(shared);
        return streamXml(file, *listener, progress, stop);
    };
    if (auto done = read(false, {}, {}); !done) return tl::make_unexpected(done.error());
    // Objects that refer to surfaces of others, before or after them: these are collected, and all is read
    // again.
    if (!listener->wantedIds.empty()) {
        if (auto done = read(true, std::move(listener->wantedIds), {}); !done)
            return tl::make_unexpected(done.error());
        if (auto done = read(false, {}, std::move(listener->shared)); !done)
            return tl::make_unexpected(done.error());
    }
    listener->warnOfInterior();
    return std::move(listener->data);
}

namespace {

constexpr const char* validatorAdvice = "Check it with a CityGML validator";

Result<FilePiece> readGml(const std::filesystem::path& file, const ReadSettings& settings, Progress& progress,
                          const std::stop_token& stop) {
    Result<CityGmlData> data = loadCityGml(file, settings, progress, stop);
    if (!data) return tl::make_unexpected(data.error());
    CityJsonData& city = data->city;
    if (data->outsideExtent > 0)
        city.warnings.push_back(
            {WarningKind::leftOut, "objects far from " + readOption("extent"),
             fmt::format("{} ({})", file.filename().string(), formatThousands(data->outsideExtent))});
    if (city.blocks.empty() && data->outsideExtent > 0)
        return FilePiece{.warnings = std::move(city.warnings), .features = city.features};
    if (city.blocks.empty())
        return failure("The file holds no buildings and no terrain", file.string(),
                       "Choose a file that contains some");
    if (auto settled = settleReference(*data, settings, file); !settled)
        return tl::make_unexpected(settled.error());
    const std::string name = file.filename().string();
    const Result<Frame> frame = placeCity(city, settings, name, stop);
    if (!frame) return tl::make_unexpected(frame.error());
    FilePiece piece{.warnings = std::move(city.warnings), .features = city.features};
    piece.format = city.version.empty() ? "CityGML" : "CityGML " + city.version;
    piece.crs = city.crsText;
    if (!settings.frame) piece.frame = *frame;
    addTin(city, name, piece);
    addTrees(city, name, *frame, piece);
    if (!addBuildings(city, settings, name, piece, progress, stop)) return cancelled();
    if (piece.buildings.empty() && !piece.terrain)
        return failure("The file holds no usable building and no usable terrain", file.string(),
                       validatorAdvice);
    return piece;
}

}  // namespace

Result<FilePiece> readCityGml(const std::filesystem::path& file, const ReadSettings& settings,
                              Progress& progress, std::stop_token stop) try {
    return readGml(file, settings, progress, stop);
} catch (const std::exception& exception) {
    return failure(fmt::format("The city cannot be read ({})", exception.what()), file.string(),
                   validatorAdvice);
}

}  // namespace noonmark
