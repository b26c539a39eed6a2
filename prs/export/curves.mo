  function interval "Index of the interval that holds a value; the first or last one beyond"
    extends Modelica.Icons.Function;
    input Real at[:];
    input Real x;
    output Integer low;
  protected
    Integer high;
    Integer middle;
  algorithm
    low := 1;
    high := size(at, 1);
    while high - low > 1 loop
      middle := div(low + high, 2);
      if x < at[middle] then
        high := middle;
      else
        low := middle;
      end if;
    end while;
  end interval;

  function branchForce "Force and stiffness of one sense, magnitudes"
    extends Modelica.Icons.Function;
    input Real deflection;
    input Real origin;
    input Boolean root;
    input Real at[:];
    input Real force[:];
    input Real slope[:];
    output Real f;
    output Real stiffness;
  protected
    Integer n = size(at, 1);
    Integer k;
    Real way;
    Real last;
    Real x;
    Real h;
    Real t;
    Real secant;
    Real c2;
    Real c3;
    Real d;
  algorithm
    way := deflection - origin;
    last := if root then at[n]^2 else at[n];
    if root and way <= 0 then
      f := 0;
      stiffness := 0;
    elseif way > last then
      stiffness := if root then slope[n]/(2*at[n]) else slope[n];
      f := force[n] + stiffness*(way - last);
    else
      x := if root then sqrt(way) else way;
      k := interval(at, x);
      h := at[k + 1] - at[k];
      t := (x - at[k])/h;
      secant := (force[k + 1] - force[k])/h;
      c2 := 3*secant - 2*slope[k] - slope[k + 1];
      c3 := slope[k] + slope[k + 1] - 2*secant;
      f := force[k] + h*t*(slope[k] + t*(c2 + t*c3));
      d := slope[k] + t*(2*c2 + 3*t*c3);
      stiffness := if root then d/(2*x) else d;
    end if;
    annotation (smoothOrder = 1);
  end branchForce;

  function forceOf "Force and stiffness over deflection; tension is positive"
    extends Modelica.Icons.Function;
    input Real deflection(unit = "m");
    output Real force(unit = "N");
    output Real stiffness(unit = "N/m");
  algorithm
    if deflection < 0 then
      (force, stiffness) := branchForce(-deflection, Data.compression_origin, Data.compression_root,
        Data.compression_at, Data.compression_force, Data.compression_slope);
      force := -force;
    else
      (force, stiffness) := branchForce(deflection, Data.tension_origin, Data.tension_root,
        Data.tension_at, Data.tension_force, Data.tension_slope);
    end if;
    annotation (smoothOrder = 1);
  end forceOf;

  function nodeSlope "Slope at a node so that the curve stays monotone (Fritsch and Butland 1984)"
    extends Modelica.Icons.Function;
    input Real x[:];
    input Real y[:];
    input Integer k;
    output Real slope;
  protected
    Integer n = size(x, 1);
    Integer i;
    Integer j;
    Real near;
    Real far;
    Real width;
    Real w;
  algorithm
    if n == 2 then
      slope := (y[2] - y[1])/(x[2] - x[1]);
    elseif k == 1 or k == n then
      i := if k == 1 then 1 else n - 1;
      j := if k == 1 then 2 else n - 2;
      near := (y[i + 1] - y[i])/(x[i + 1] - x[i]);
      far := (y[j + 1] - y[j])/(x[j + 1] - x[j]);
      width := x[i + 1] - x[i];
      slope := near + (near - far)*width/(width + x[j + 1] - x[j]);
      if slope*near <= 0 then
        slope := 0;
      elseif near*far <= 0 and abs(slope) > 3*abs(near) then
        slope := 3*near;
      end if;
    else
      near := (y[k] - y[k - 1])/(x[k] - x[k - 1]);
      far := (y[k + 1] - y[k])/(x[k + 1] - x[k]);
      w := (x[k] - x[k - 1] + 2*(x[k + 1] - x[k]))/(3*(x[k + 1] - x[k - 1]));
      slope := if near*far <= 0 then 0 else near*far/(w*far + (1 - w)*near);
    end if;
  end nodeSlope;

  function between "Monotone curve through nodes; beyond them the value of the last one"
    extends Modelica.Icons.Function;
    input Real x[:];
    input Real y[:];
    input Real at;
    output Real value;
  protected
    Integer n = size(x, 1);
    Integer k;
    Real h;
    Real t;
    Real secant;
    Real d0;
    Real d1;
  algorithm
    if n == 1 or at <= x[1] then
      value := y[1];
    elseif at >= x[n] then
      value := y[n];
    else
      k := interval(x, at);
      h := x[k + 1] - x[k];
      t := (at - x[k])/h;
      secant := (y[k + 1] - y[k])/h;
      d0 := nodeSlope(x, y, k);
      d1 := nodeSlope(x, y, k + 1);
      value := y[k] + h*t*(d0 + t*(3*secant - 2*d0 - d1 + t*(d0 + d1 - 2*secant)));
    end if;
  end between;

  function frictionAt "What friction takes while turning in one sense"
    extends Modelica.Icons.Function;
    input Real torque[:, :];
    input Real root;
    input Real speed;
    output Real friction;
  protected
    Integer n = size(torque, 1);
    Integer first;
    Integer count;
    Real x[4];
    Real y[4];
  algorithm
    first := 1;
    count := min(n, 4);
    if n > 4 then
      first := min(max(interval(Data.slowest, speed) - 1, 1), n - 3);
    end if;
    for k in 1:count loop
      x[k] := sqrt(sqrt(Data.slowest[first + k - 1]));
      y[k] := between(Data.root_force, torque[first + k - 1, :], root);
    end for;
    friction := between(x[1:count], y[1:count], sqrt(sqrt(speed)));
  end frictionAt;

  function torqueOf "Torque of the drive on the screw"
    extends Modelica.Icons.Function;
    input Real force(unit = "N");
    input Real speed(unit = "rad/s");
    output Real torque(unit = "N.m");
  protected
    Real root;
    Real last;
    Real factor;
    Real friction;
    Real slowest;
    Real forward;
    Real backward;
  algorithm
    friction := 0;
    if size(Data.root_force, 1) > 0 then
      root := if force < 0 then -sqrt(-force) else sqrt(force);
      last := if force < 0 then Data.root_force[1] else Data.root_force[size(Data.root_force, 1)];
      factor := 1;
      if abs(root) > abs(last) then
        factor := force/(last*abs(last));
        root := last;
      end if;
      slowest := Data.slowest[1];
      if abs(speed) < slowest then
        forward := frictionAt(Data.forward, root, slowest);
        backward := frictionAt(Data.backward, root, slowest);
        friction := factor*(backward + (forward - backward)*(0.5 + 0.5*speed/slowest));
      elseif speed < 0 then
        friction := factor*frictionAt(Data.backward, root, -speed);
      else
        friction := factor*frictionAt(Data.forward, root, speed);
      end if;
    end if;
    torque := force*Data.lead/(2*Modelica.Constants.pi) + friction;
  end torqueOf;

  block Curves "Force, stiffness and torque over deflection and speed"
    extends Modelica.Blocks.Icons.Block;
    Modelica.Blocks.Interfaces.RealInput deflection(unit = "m")
      "Loaded section of the screw against the section that holds the nut; > 0 in tension"
      annotation (Placement(transformation(extent = {{-140, 40}, {-100, 80}})));
    Modelica.Blocks.Interfaces.RealInput speed(unit = "rad/s") "Screw against nut"
      annotation (Placement(transformation(extent = {{-140, -80}, {-100, -40}})));
    Modelica.Blocks.Interfaces.RealOutput force(unit = "N") "> 0 in tension"
      annotation (Placement(transformation(extent = {{100, 50}, {120, 70}})));
    Modelica.Blocks.Interfaces.RealOutput stiffness(unit = "N/m") "Change of force with deflection"
      annotation (Placement(transformation(extent = {{100, -10}, {120, 10}})));
    Modelica.Blocks.Interfaces.RealOutput torque(unit = "N.m") "Of the drive on the screw"
      annotation (Placement(transformation(extent = {{100, -70}, {120, -50}})));
  equation
    (force, stiffness) = forceOf(deflection);
    torque = torqueOf(force, speed);
  end Curves;

  model Screw "Shaft that drives a load through the elastic screw"
    Modelica.Mechanics.Rotational.Interfaces.Flange_a shaft "Screw against nut"
      annotation (Placement(transformation(extent = {{-110, -10}, {-90, 10}})));
    Modelica.Mechanics.Translational.Interfaces.Flange_b load "Screw against the housing of the nut"
      annotation (Placement(transformation(extent = {{90, -10}, {110, 10}})));
    Curves curves;
  equation
    curves.deflection = Data.lead/(2*Modelica.Constants.pi)*shaft.phi - load.s;
    curves.speed = der(shaft.phi);
    shaft.tau = curves.torque;
    load.f = -curves.force;
  end Screw;
