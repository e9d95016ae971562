#include "app/input/load_context.h"

#include <algorithm>
#include <iterator>

#include "app/input/load_city.h"
#include "core/io/places/read_places.h"
#include "core/samples/sample_city.h"

namespace noonmark {

namespace {

void append(MapContext& to, MapContext from) {
    std::ranges::move(from.areas, std::back_inserter(to.areas));
    std::ranges::move(from.lines, std::back_inserter(to.lines));
    std::ranges::move(from.trees, std::back_inserter(to.trees));
    if (to.attribution.empty()) to.attribution = std::move(from.attribution);
}

}  // namespace

Result<ContextRead> loadCityContext(const std::vector<std::string>& files, const Frame& frame,
                                    Progress& progress, const std::stop_token& stop) {
    ContextRead all;
    for (const std::string& file : files) {
        if (isParkSample(file)) append(all.context, makeCentralParkContext(frame));
        if (isSample(file) || !isOsmFile(file)) continue;
        auto read = readContext(file, {}, frame, progress, stop);
        if (!read) return tl::make_unexpected(read.error());
        append(all.context, std::move(read->context));
        std::ranges::move(read->warnings, std::back_inserter(all.warnings));
        all.features += read->features;
    }
    return all;
}

std::shared_ptr<const MapContext> joinContext(const std::shared_ptr<const MapContext>& before,
                                              MapContext added) {
    auto joined = std::make_shared<MapContext>(before ? *before : MapContext{});
    append(*joined, std::move(added));
    return joined->empty() ? nullptr : joined;
}

}  // namespace noonmark
