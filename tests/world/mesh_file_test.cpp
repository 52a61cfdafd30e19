#include "world/mesh_file.hpp"

#include <opencv2/imgcodecs.hpp>

#include "core/result.hpp"
#include "files_for_test.hpp"

namespace amiss::world {
namespace {

using MeshFileTest = FilesForTest;

/// A unit square in x-z of a Collada file, 1 unit long in the file's own unit.
std::string collada(const std::string& up_axis, const std::string& metres) {
  return "<?xml version='1.0'?><COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' "
         "version='1.4.1'><asset><unit name='u' meter='" +
         metres + "'/><up_axis>" + up_axis + R"(</up_axis></asset><library_geometries><geometry id='g' name='g'><mesh>
      <source id='p'><float_array id='pa' count='12'>0 0 0 1 0 0 1 0 2 0 0 2</float_array><technique_common>
      <accessor source='#pa' count='4' stride='3'><param name='X' type='float'/><param name='Y' type='float'/><param name='Z' type='float'/>
      </accessor></technique_common></source><vertices id='v'><input semantic='POSITION' source='#p'/></vertices>
      <triangles count='2'><input semantic='VERTEX' source='#v' offset='0'/><p>0 1 2 0 2 3</p></triangles></mesh></geometry></library_geometries>
      <library_visual_scenes><visual_scene id='s'><node id='n' name='panel'><instance_geometry url='#g'/></node></visual_scene></library_visual_scenes>
      <scene><instance_visual_scene url='#s'/></scene></COLLADA>)";
}

Eigen::AlignedBox3f box_of(const MeshFile& file) {
  Eigen::AlignedBox3f box;
  for (const MeshPart& part : file.parts) {
    for (const Eigen::Vector3f& v : part.mesh->vertices) box.extend(v);
  }
  return box;
}

TEST_F(MeshFileTest, AppliesTheUnitOfColladaAndNeverItsUpAxis) {
  for (const std::string up : {"X_UP", "Y_UP", "Z_UP"}) {
    const MeshFile file = load_mesh(write(up + ".dae", collada(up, "0.01")));
    EXPECT_LT((box_of(file).max() - Eigen::Vector3f(0.01F, 0, 0.02F)).norm(), 1e-6F) << up;
    EXPECT_LT(box_of(file).min().norm(), 1e-6F) << up;
    EXPECT_EQ(file.parts.at(0).name, "panel");
  }
}

TEST_F(MeshFileTest, ComputesNormalsAndKeepsWinding) {
  const MeshFile file = load_mesh(write("a.dae", collada("Z_UP", "1")));
  const Mesh& mesh = *file.parts.at(0).mesh;
  ASSERT_EQ(mesh.indices.size(), 6U);
  ASSERT_EQ(mesh.normals.size(), mesh.vertices.size());
  for (const Eigen::Vector3f& n : mesh.normals) EXPECT_LT((n - Eigen::Vector3f(0, -1, 0)).norm(), 1e-5F);
}

TEST_F(MeshFileTest, ReadsObjWithTextureScaledDown) {
  cv::imwrite((folder_ / "t.png").string(), cv::Mat(600, 300, CV_8UC3, cv::Scalar(10, 20, 200)));
  write("m.mtl", "newmtl a\nKd 0.2 0.2 0.2\nmap_Kd t.png\n");
  const MeshFile file = load_mesh(
      write("m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl a\nf 1/1 2/2 3/3\n"),
      100);
  const MeshPart& part = file.parts.at(0);
  ASSERT_NE(part.material.texture, nullptr);
  EXPECT_EQ(part.material.texture->width, 50);
  EXPECT_EQ(part.material.texture->height, 100);
  EXPECT_EQ(part.material.texture->pixels.at(0), (Rgb{200, 20, 10}));
  EXPECT_EQ(part.material.diffuse, Eigen::Vector3f::Ones());
  EXPECT_EQ(part.mesh->uvs.size(), 3U);
}

TEST_F(MeshFileTest, ReadsVertexColours) {
  const MeshFile file = load_mesh(write(
      "m.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty uchar "
      "red\n"
      "property uchar green\nproperty uchar blue\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 255\n3 0 1 2\n"));
  const Mesh& mesh = *file.parts.at(0).mesh;
  ASSERT_EQ(mesh.colours.size(), 3U);
  EXPECT_EQ(mesh.colours[0], (Rgb{255, 0, 0}));
  EXPECT_EQ(file.parts[0].material.diffuse, Eigen::Vector3f::Ones());
}

TEST_F(MeshFileTest, MissingTextureIsAWarningAndBrokenFilesAreErrors) {
  write("m.mtl", "newmtl a\nmap_Kd gone.png\n");
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\n";
  const MeshFile file = load_mesh(write("m.obj", "mtllib m.mtl\n" + triangle));
  ASSERT_EQ(file.warnings.size(), 1U);
  EXPECT_NE(file.warnings[0].find("gone.png"), std::string::npos);
  EXPECT_THROW((void)load_mesh(write("e.dae", "")), InputError);
  EXPECT_THROW((void)load_mesh(write("e.stl", "random words")), InputError);
  EXPECT_THROW((void)load_mesh(write("e.xyz", "random words")), InputError);
  EXPECT_THROW((void)load_mesh(folder_ / "absent.obj"), InputError);
  EXPECT_THROW((void)load_texture(write("e.png", "\x89PNG not a picture")), InputError);
  EXPECT_THROW((void)load_texture(write("z.png", "")), InputError);
}

}  // namespace
}  // namespace amiss::world
