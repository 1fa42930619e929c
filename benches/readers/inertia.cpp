// What libsdformat makes of a model: for each link its pose in the model and its inertial pose, mass and moments.
//   g++ -std=c++17 inertia.cpp -o inertia $(pkg-config --cflags --libs sdformat12)
#include <cstdio>
#include <sdf/sdf.hh>

static void print(const sdf::Model &model, const ignition::math::Pose3d &at, const std::string &scope) {
    for (uint64_t i = 0; i < model.LinkCount(); ++i) {
        const auto *link = model.LinkByIndex(i);
        ignition::math::Pose3d pose, inertial;
        if (!link->SemanticPose().Resolve(pose, "__model__").empty()) {
            std::printf("unresolved %s%s\n", scope.c_str(), link->Name().c_str());
            continue;
        }
        const auto whole = at * pose;
        const auto inertia = link->Inertial();
        const auto centre = whole * inertia.Pose();
        const auto turn = ignition::math::Matrix3d(centre.Rot());
        const auto moments = turn * inertia.MassMatrix().Moi() * turn.Transposed();
        std::printf("%s%s %.17g %.17g %.17g %.17g", scope.c_str(), link->Name().c_str(), inertia.MassMatrix().Mass(),
                    centre.Pos().X(), centre.Pos().Y(), centre.Pos().Z());
        for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 3; ++c) std::printf(" %.17g", moments(r, c));
        std::printf(" %.17g %.17g %.17g\n", whole.Pos().X(), whole.Pos().Y(), whole.Pos().Z());
    }
    for (uint64_t i = 0; i < model.ModelCount(); ++i) {
        const auto *inner = model.ModelByIndex(i);
        ignition::math::Pose3d pose;
        if (inner->SemanticPose().Resolve(pose, "__model__").empty()) print(*inner, at * pose, scope + inner->Name() + "::");
    }
}

int main(int, char **argv) {
    sdf::Root root;
    for (const auto &error : root.Load(argv[1])) std::fprintf(stderr, "%s\n", error.Message().c_str());
    if (root.Model() == nullptr) return 1;
    print(*root.Model(), ignition::math::Pose3d(), "");
    return 0;
}
