#pragma once

#include <QColor>
#include <QVector3D>
#include <glm/vec3.hpp>

namespace noonmark {

/// Qt's vectors of positions in local metres, and of colours with parts from 0 to 1.
inline QVector3D toVector(const glm::dvec3& v) { return {float(v.x), float(v.y), float(v.z)}; }
inline QVector3D toVector(const QColor& c) { return {float(c.redF()), float(c.greenF()), float(c.blueF())}; }

}  // namespace noonmark
