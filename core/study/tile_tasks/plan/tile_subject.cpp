#include "core/study/tile_tasks/plan/tile_subject.h"

#include "core/study/provenance/sha256.h"
#include "core/study/provenance/study_hash.h"

namespace noonmark {

std::string hashQuestion(StudySettings settings, const TileSubject* subject) {
    settings.region = {};
    const std::string hash = hashSettings(settings);
    if (subject == nullptr) return hash;
    Sha256 sum;
    sum.add(hash);
    sum.add(subject->key);
    return sum.hex();
}

}  // namespace noonmark
