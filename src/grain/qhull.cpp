#include "src/grain/qhull.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace demens::grain {
namespace {

//! A run of Qhull and what it says, given back to the system at the end.
class Run
{
  public:
    explicit Run(std::vector<double>& coordinates)
    {
        qh_zero(&state, messages_);
        char command[] = "qhull Qt Pp"; // triangles; no warnings about precision
        failed = qh_new_qhull(&state, 3, static_cast<int>(coordinates.size() / 3), coordinates.data(), False,
                              command, nullptr, messages_) != 0;
    }
    Run(Run const&) = delete;
    Run& operator=(Run const&) = delete;
    ~Run()
    {
        int rest = 0, pieces = 0;
        qh_freeqhull(&state, !qh_ALL);
        qh_memfreeshort(&state, &rest, &pieces);
        std::fclose(messages_);
        std::free(text_);
    }
    std::string said()
    {
        std::fflush(messages_);
        return {text_, size_};
    }

    qhT state{};
    bool failed = false;

  private:
    char* text_ = nullptr;
    std::size_t size_ = 0;
    std::FILE* messages_ = open_memstream(&text_, &size_);
};

} // namespace

QhullResult run_qhull(std::span<Vector3 const> points)
{
    std::vector<double> coordinates;
    coordinates.reserve(3 * points.size());
    for (Vector3 const& p : points)
        coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
    Run run(coordinates);
    QhullResult result;
    if (run.failed) {
        result.error = run.said();
        return result;
    }
    qhT* qh = &run.state; // Qhull's macros take it by this name
    facetT* facet = nullptr;
    FORALLfacets
    {
        std::array<std::size_t, 3> corners{};
        for (int k = 0; k < 3; ++k) {
            auto const* vertex = static_cast<vertexT*>(SETelem_(facet->vertices, k));
            corners[static_cast<std::size_t>(k)] = static_cast<std::size_t>(qh_pointid(qh, vertex->point));
        }
        if (facet->toporient)
            std::swap(corners[1], corners[2]);
        result.triangles.push_back({corners, {facet->normal[0], facet->normal[1], facet->normal[2]}});
    }
    double volume = 0; // its sign tells the sense in which all triangles go round
    for (auto const& [c, normal] : result.triangles)
        volume += dot(points[c[0]], cross(points[c[1]], points[c[2]]));
    if (volume < 0)
        for (auto& triangle : result.triangles)
            std::swap(triangle.corners[1], triangle.corners[2]);
    return result;
}

} // namespace demens::grain
