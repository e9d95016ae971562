#include "app/gui/base/widgets/height_words.h"

#include <QObject>

#include "app/gui/base/looks/height_reference.h"
#include "app/gui/base/widgets/number_words.h"
#include "core/city/city.h"
#include "core/geo/earth_drop.h"

namespace noonmark {

double computeElevation(const City& city, glm::dvec3 local) {
    const double dropM = city.terrain ? earthDropM({local.x, local.y}) : 0;
    return local.z + city.frame.originElevationM() + dropM;
}

double heightZeroM(double groundElevationM) {
    return heightReferenceInUse() == HeightReference::datum ? groundElevationM : 0;
}

QString describeHeight(double aboveGroundM, double groundElevationM) {
    const QString text = describeLength(aboveGroundM + heightZeroM(groundElevationM));
    return heightReferenceInUse() == HeightReference::datum ? QObject::tr("%1 above datum").arg(text)
                                                            : QObject::tr("%1 above ground").arg(text);
}

}  // namespace noonmark
