"""MuJoCo: a one-dimensional flex, whose edges are springs between its vertices; f64, contacts off."""

import mujoco
import numpy as np

from worker import steps, timed

XML = """<mujoco>
  <option integrator="Euler" gravity="{gravity}"><flag contact="disable"/></option>
  <worldbody>
    <flexcomp name="springs" type="direct" dim="1" mass="{mass}" point="{points}" element="{elements}" radius="0.0001">
      <contact selfcollide="none" contype="0" conaffinity="0"/>
      <edge stiffness="{stiffness}" damping="{damping}"/>
      <pin id="{pinned}"/>
    </flexcomp>
  </worldbody>
</mujoco>"""


def text(values):
    return " ".join(map(repr, np.ravel(values).tolist()))


class Flex:
    def __init__(self, scene):
        if scene.planes:
            raise ValueError("its contacts are not the plane's law")
        for column in (scene.mass, scene.stiffness, scene.damping):
            if np.ptp(column):
                raise ValueError("one mass, one stiffness and one damping for all")
        xml = XML.format(
            gravity=text(scene.gravity),
            mass=repr(float(scene.mass.sum())),
            points=text(scene.position),
            elements=text(scene.between),
            stiffness=repr(float(scene.stiffness[0])),
            damping=repr(float(scene.damping[0])),
            pinned=text(scene.pinned),
        )
        self.scene = scene
        self.model = mujoco.MjModel.from_xml_string(xml)
        self.model.flexedge_length0[:] = scene.rest_length[self.order()]

    def order(self):
        """Which spring of the scene each edge of the flex is."""
        numbers = {tuple(sorted(ends)): spring for spring, ends in enumerate(self.scene.between.tolist())}
        return [numbers[tuple(sorted(edge))] for edge in self.model.flex_edge.tolist()]

    def run(self, time_step, duration):
        self.model.opt.timestep = time_step
        data = mujoco.MjData(self.model)
        count = steps(time_step, duration)

        def go():
            for _ in range(count):
                mujoco.mj_step(self.model, data)

        cpu, _ = timed(go)
        if data.warning[mujoco.mjtWarning.mjWARN_BADQACC].number:
            raise RuntimeError("it diverged and started again")
        mujoco.mj_kinematics(self.model, data)
        mujoco.mj_flex(self.model, data)
        return cpu, data.flexvert_xpos


def peer(_, scene):
    return Flex(scene)
