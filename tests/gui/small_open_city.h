#pragma once

#include "app/gui/session/study/open_city.h"
#include "tests/gui/small_city.h"

namespace noonmark::test {

/// The small city, ready for display.
inline std::shared_ptr<const OpenCity> smallOpenCity() {
    auto open = std::make_shared<OpenCity>();
    open->loaded.read.city = smallCity();
    open->arrays = std::make_shared<const CityArrays>(makeArrays(open->city()));
    open->picker = ScenePicker(open->city(), RayScene::over(open->city()).value());
    return open;
}

}  // namespace noonmark::test
