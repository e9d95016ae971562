#include "core/engines/inverse/sources/projected_source_finder.h"

#include "core/engines/inverse/sources/projected_facets.h"

namespace noonmark {

ProjectedSourceFinder::ProjectedSourceFinder(SurfaceFacets facets, int levels, float nearestHitM)
    : facets_(std::move(facets)), levels_(levels), nearestHitM_(nearestHitM) {}

std::unique_ptr<SourceInstant> ProjectedSourceFinder::at(glm::dvec3 towardsSun, const Lanes& lanes) const {
    return std::make_unique<ProjectedFacets>(facets_, lanes, towardsSun, nearestHitM_);
}

}  // namespace noonmark
