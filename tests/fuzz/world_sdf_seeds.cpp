#include "fuzz/seeds.hpp"

namespace amiss::fuzz {

std::vector<std::string> valid_inputs() {
  return {R"(<?xml version="1.0"?>
<sdf version="1.9"><world name="w"><frame name="robot_start"><pose>1 1 0 0 0 0.5</pose></frame>
<model name="floor"><static>true</static><link name="l"><collision name="c"><geometry><plane><normal>0 0 1</normal>
<size>5 5</size></plane></geometry></collision></link></model>
<model name="m"><pose relative_to="floor">0 1 0.5 0 0 1.57</pose><link name="a"><inertial><mass>2</mass></inertial>
<visual name="v"><geometry><box><size>1 0.5 0.2</size></box></geometry><material><diffuse>1 0 0 1</diffuse></material>
</visual></link><link name="b"><pose relative_to="a">0 0 1 0 0 0</pose><collision name="c"><geometry><cylinder>
<radius>0.1</radius><length>0.4</length></cylinder></geometry></collision></link>
<joint name="j" type="revolute"><parent>a</parent><child>b</child><axis><xyz>0 0 1</xyz></axis></joint></model>
<include><uri>model://nowhere</uri><name>n</name></include></world></sdf>)"};
}

std::vector<std::string> words() {
  return {"<link name=\"x\"/>",
          "<model name=\"m\">",
          "</model>",
          "<sphere><radius>-1</radius></sphere>",
          "<!--",
          "relative_to=\"m\"",
          "__model__",
          "::",
          "<uri>file:///dev/zero</uri>",
          "<mesh><uri>x.dae</uri></mesh>",
          "\"",
          "/>"};
}

}  // namespace amiss::fuzz
